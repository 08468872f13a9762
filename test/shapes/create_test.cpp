// Mistakes in shapes' parameters are errors that say where and what.

#include "shapes/make.h"

namespace pbrt {
namespace {

void ExpectSays(std::string_view text, const Texts &messages) {
    const Made made = Make(text);
    EXPECT_EQ(made.messages, messages) << text;
    EXPECT_TRUE(made.shapes.empty()) << text;
}

TEST(CreateShapes, QuadricsRejectWhatCannotBe) {
    ExpectSays(R"(Shape "sphere" "float radius" 0)",
               {R"(test.pbrt:2:31: "float radius": 0 is not more than 0)"});
    ExpectSays(R"(Shape "sphere" "float radius" -2)",
               {R"(test.pbrt:2:31: "float radius": -2 is not more than 0)"});
    ExpectSays(R"(Shape "sphere" "float zmin" 0.5 "float zmax" -0.5)",
               {"test.pbrt:2:16: zmin, 0.5, is not less than zmax, -0.5"});
    ExpectSays(R"(Shape "sphere" "float zmin" 2 "float zmax" 3)",
               {"test.pbrt:2:16: zmin, 2, to zmax, 3, leaves nothing of the radius, 1"});
    ExpectSays(R"(Shape "sphere" "float phimax" 0)",
               {R"(test.pbrt:2:31: "float phimax": 0 is outside (0, 360] deg)"});
    ExpectSays(R"(Shape "disk" "float innerradius" 1)",
               {R"(test.pbrt:2:14: "float innerradius": 1 is outside [0, 1))"});
    ExpectSays(R"(Shape "cylinder" "float zmax" -1)",
               {"test.pbrt:2:18: zmin, -1, is not less than zmax, -1"});
    ExpectSays(R"(Transform [1 0 0 0.1  0 1 0 0  0 0 1 0  0 0 0 1] Shape "sphere")",
               {R"(test.pbrt:2:50: shape "sphere" cannot be placed by a perspective transform)"});
    const Made made = Make(R"(Shape "sphere" "float zmin" -5 "float zmax" 0.5)");
    EXPECT_EQ(made.messages, Texts{});
    EXPECT_EQ(std::get<Sphere>(made.shapes.at(0)).zMin, -1);
}

TEST(CreateShapes, MeshesNeedWhatFitsTogether) {
    ExpectSays(R"(Shape "trianglemesh")",
               {R"(test.pbrt:2:1: shape "trianglemesh" needs "point3 P")"});
    ExpectSays(
        R"(Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0 ])",
        {R"(test.pbrt:2:1: shape "trianglemesh" needs "integer indices", for it has 2 points and not 3)"});
    ExpectSays(
        R"(Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ] "integer indices" [ 0 1 ])",
        {R"(test.pbrt:2:57: "integer indices": 2 values are not a multiple of 3)"});
    ExpectSays(
        R"(Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ] "integer indices" [ 0 1 3 ])",
        {R"(test.pbrt:2:57: "integer indices": value 2 is 3, but "P" has 3 points (0 to 2))"});
    ExpectSays(
        R"(Shape "bilinearmesh" "point3 P" [ 0 0 0  1 0 0  0 1 0  1 1 0 ] "integer indices" [ 0 1 2 -1 ])",
        {R"(test.pbrt:2:64: "integer indices": value 3 is -1, but "P" has 4 points (0 to 3))"});
    ExpectSays(R"(Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ] "normal N" [ 0 0 1 ]
"vector3 S" [ 0 0 1  1 0 0 ] "point2 uv" [ 0 0 ] "integer faceIndices" [ 1 2 ])",
               {R"(test.pbrt:2:57: "normal N": 1 values for 3 points)",
                R"(test.pbrt:3:1: "vector3 S": 2 values for 3 points)",
                R"(test.pbrt:3:30: "point2 uv": 1 values for 3 points)",
                R"(test.pbrt:3:50: "integer faceIndices": 2 values for 1 triangles)"});
    ExpectSays(
        R"(Scale 1e30 1 1 Shape "trianglemesh" "point3 P" [ 0 0 0  1e20 0 0  0 1 0 ])",
        {R"(test.pbrt:2:16: shape "trianglemesh": point 1 is not finite: (1e+20, 0, 0) placed at (inf, 0, 0))"});
    ExpectSays(R"(Shape "plymesh")", {R"(test.pbrt:2:1: shape "plymesh" needs "string filename")"});
}

TEST(CreateShapes, UnknownNamesListWhatIsKnown) {
    ExpectSays(R"(Shape "spher")",
               {R"(test.pbrt:2:1: unknown shape "spher"; did you mean "sphere"? Known: )" +
                QuotedList(ShapeDirectives::kNames)});
}

TEST(CreateShapes, PointsLeaveRoomForSixteenByteReads) {
    const Shape shape = MakeOne(R"(Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ])");
    const auto &mesh = std::get<TriangleMesh>(shape);
    EXPECT_GT(mesh.p.capacity(), mesh.p.size());
}

}  // namespace
}  // namespace pbrt
