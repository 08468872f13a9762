// Transformations, scopes and inherited parameters.

#include <gtest/gtest.h>

#include "scene/parse.h"

namespace pbrt {
namespace {

/// RenderScene-from-object of the only shape, at the shutter's start.
Transform ShapeTransform(const std::string &world, int time = 0) {
    const auto parsed = ParseWorld(world + "\nShape \"a\"");
    EXPECT_EQ(parsed->Messages(), Texts{}) << world;
    return All(parsed->scene.shapes).at(0).worldFromObject[time];
}

void ExpectNear(const Matrix4 &a, const Matrix4 &b) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_NEAR(a[i][j], b[i][j], 1e-6f) << i << ' ' << j;
}

TEST(State, TransformsMultiplyFromTheRight) {
    // The directive written last acts on the point first.
    const Point3f p = ShapeTransform("Translate 1 2 3 Scale 2 3 4").Point({1, 1, 1});
    EXPECT_EQ(p, (Point3f{3, 5, 7}));
    const Point3f q = ShapeTransform("Scale 2 3 4 Translate 1 2 3").Point({1, 1, 1});
    EXPECT_EQ(q, (Point3f{4, 9, 16}));
}

TEST(State, RotateIsRightHandedInDegrees) {
    const Vector3f v = ShapeTransform("Rotate 90 0 0 2").Vector({1, 0, 0});
    EXPECT_NEAR(v.x, 0, 1e-6f);
    EXPECT_NEAR(v.y, 1, 1e-6f);
}

TEST(State, WhatAMatrixWithoutInversePlacesIsLeftOut) {
    constexpr char kFlat[] = "[ 1 0 0 0  0 0 0 0  0 0 1 0  0 0 0 1 ]";
    for (const std::string &flat :
         {std::string("Scale 1 0 1"), std::string("Transform ") + kFlat,
          std::string("ConcatTransform ") + kFlat,
          std::string("ActiveTransform EndTime Scale 0 1 1 ActiveTransform All")}) {
        const auto parsed = ParseWorld(
            "ObjectBegin \"o\" Shape \"a\" ObjectEnd\nAttributeBegin\n" + flat +
            " Translate 1 2 3\nShape \"b\" ObjectInstance \"o\" LightSource \"c\"\n"
            "CoordinateSystem \"hidden\"\nIdentity Shape \"d\"\nCoordSysTransform \"hidden\" Shape "
            "\"e\"\nAttributeEnd Shape \"f\" LightSource \"g\" ObjectInstance \"o\"");
        ASSERT_EQ(parsed->Messages().size(), 1u) << flat;
        EXPECT_FALSE(parsed->log.HasErrors());
        EXPECT_NE(parsed->Messages()[0].find("this transformation has no inverse"),
                  std::string::npos);
        const std::vector<ShapeEntity> shapes = All(parsed->scene.shapes);
        ASSERT_EQ(shapes.size(), 2u) << flat;
        EXPECT_EQ(shapes[0].type, "d");
        EXPECT_EQ(shapes[1].type, "f");
        ASSERT_EQ(parsed->scene.lights.size(), 1u);
        EXPECT_EQ(parsed->scene.lights[0].type, "g");
        EXPECT_EQ(parsed->scene.instances.size(), 1u);
    }
}

TEST(State, ACameraNeedsAnInverse) {
    const auto parsed = Parse("Scale 0 1 1 Camera \"perspective\" WorldBegin");
    EXPECT_EQ(parsed->log.ErrorCount(), 1);
}

TEST(State, OlderNamesOfInterface) {
    const auto parsed = ParseWorld(
        "Material \"\"\nMaterial \"none\"\nMakeNamedMaterial \"m\" \"string type\" \"none\"");
    EXPECT_EQ(parsed->Messages(),
              (Texts{"test.pbrt:2:1: material \"\" is an older name of \"interface\"",
                     "test.pbrt:3:1: material \"none\" is an older name of \"interface\"",
                     "test.pbrt:4:1: material \"none\" is an older name of \"interface\""}));
    for (const Entity &material : All(parsed->scene.materials))
        EXPECT_EQ(material.type, "interface");
    EXPECT_EQ(parsed->scene.namedMaterials.at(0).type, "interface");
}

TEST(State, IdentityForgets) {
    EXPECT_TRUE(ShapeTransform("Translate 1 2 3 Identity") == Transform());
}

TEST(State, MatricesAreColumnMajor) {
    const std::string m = "[ 1 0 0 0  0 2 0 0  0 0 3 0  4 5 6 1 ]";
    EXPECT_EQ(ShapeTransform("Translate 9 9 9 Transform " + m).Point({1, 1, 1}),
              (Point3f{5, 7, 9}));
    EXPECT_EQ(ShapeTransform("Translate 9 9 9 ConcatTransform " + m).Point({1, 1, 1}),
              (Point3f{14, 16, 18}));
}

TEST(State, LookAtPutsTheTargetOnThePositiveZAxis) {
    const auto parsed = Parse("LookAt 1 2 3  1 2 8  0 1 0 Camera \"perspective\" WorldBegin");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const Point3f target = parsed->scene.cameraFromWorld[0].Point({1, 2, 8});
    EXPECT_NEAR(target.x, 0, 1e-6f);
    EXPECT_NEAR(target.y, 0, 1e-6f);
    EXPECT_NEAR(target.z, 5, 1e-6f);
}

TEST(State, WorldBeginForgetsTheCamerasTransform) {
    const auto parsed = Parse(
        "Translate 1 2 3 ActiveTransform EndTime Camera \"perspective\" "
        "WorldBegin Scale 2 2 2 Shape \"a\"");
    EXPECT_EQ(All(parsed->scene.shapes).at(0).worldFromObject[0], *Transform::Scale({2, 2, 2}));
    EXPECT_EQ(All(parsed->scene.shapes)[0].worldFromObject[1], *Transform::Scale({2, 2, 2}));
    EXPECT_EQ(parsed->scene.cameraFromWorld[0], Transform::Translate({1, 2, 3}));
}

TEST(State, ActiveTransformChoosesTheTime) {
    const std::string moving =
        "ActiveTransform StartTime Translate 1 0 0 "
        "ActiveTransform EndTime Translate 0 1 0 "
        "ActiveTransform All Translate 0 0 1";
    EXPECT_EQ(ShapeTransform(moving, 0), Transform::Translate({1, 0, 1}));
    EXPECT_EQ(ShapeTransform(moving, 1), Transform::Translate({0, 1, 1}));
}

TEST(State, ActiveTransformIsScoped) {
    const std::string scoped =
        "AttributeBegin ActiveTransform EndTime AttributeEnd Translate 1 0 0";
    EXPECT_EQ(ShapeTransform(scoped, 0), Transform::Translate({1, 0, 0}));
}

TEST(State, CoordinateSystemsAreSavedForBothTimes) {
    const std::string saved =
        "ActiveTransform EndTime Translate 1 0 0 CoordinateSystem \"here\" "
        "ActiveTransform All Identity Scale 2 2 2 CoordSysTransform \"here\"";
    EXPECT_TRUE(ShapeTransform(saved, 0) == Transform());
    EXPECT_EQ(ShapeTransform(saved, 1), Transform::Translate({1, 0, 0}));
}

TEST(State, CameraAndWorldArePredefined) {
    const auto parsed = Parse(
        "Translate 1 2 3 Camera \"perspective\" WorldBegin\n"
        "CoordSysTransform \"camera\" Shape \"a\" "
        "CoordSysTransform \"world\" Shape \"b\"");
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(All(parsed->scene.shapes).at(0).worldFromObject[0],
              Transform::Translate({-1, -2, -3}));
    EXPECT_TRUE(All(parsed->scene.shapes).at(1).worldFromObject[0] == Transform());
}

TEST(State, CoordinateSystemsOutliveScopes) {
    const auto parsed = ParseWorld(
        "AttributeBegin Translate 1 0 0 CoordinateSystem \"c\" "
        "AttributeEnd CoordSysTransform \"c\" Shape \"a\"");
    EXPECT_EQ(All(parsed->scene.shapes).at(0).worldFromObject[0], Transform::Translate({1, 0, 0}));
}

TEST(State, UnknownCoordinateSystemIsAWarning) {
    const auto parsed = ParseWorld("Translate 1 0 0\nCoordSysTransform \"Camra\"\nShape \"a\"");
    EXPECT_EQ(parsed->Messages(),
              Texts{"test.pbrt:3:19: CoordSysTransform: no coordinate system \"Camra\"; the "
                    "transformation stays as it was"});
    EXPECT_FALSE(parsed->log.HasErrors());
    EXPECT_EQ(All(parsed->scene.shapes).at(0).worldFromObject[0], Transform::Translate({1, 0, 0}));
}

TEST(State, MovingLightsAndTexturesUseTheStart) {
    const auto parsed = ParseWorld(
        "ActiveTransform EndTime Translate 1 0 0\n"
        "LightSource \"point\"\nTexture \"t\" \"float\" \"constant\"");
    EXPECT_EQ(parsed->Messages(),
              (Texts{"test.pbrt:3:1: a light cannot move: its transformation at the shutter's "
                     "opening is used throughout",
                     "test.pbrt:4:1: a texture cannot move: its transformation at the shutter's "
                     "opening is used throughout"}));
    EXPECT_TRUE(parsed->scene.lights.at(0).worldFromLight == Transform());
    EXPECT_FALSE(parsed->log.HasErrors());
}

TEST(State, MovingAreaLight) {
    const auto parsed = ParseWorld(
        "AreaLightSource \"diffuse\" ActiveTransform EndTime "
        "Translate 1 0 0\nShape \"a\"");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const ShapeEntity shape = *parsed->scene.shapes.begin();
    EXPECT_TRUE(shape.areaLight && !(shape.worldFromObject[0] == shape.worldFromObject[1]));
}

TEST(State, AttributeScopesRestoreEverything) {
    const auto parsed = ParseWorld(R"(
        ReverseOrientation
        AttributeBegin
            ReverseOrientation  Translate 1 0 0  Material "diffuse"
            ColorSpace "rec2020" Attribute "shape" "float alpha" 0
            AttributeBegin Scale 2 2 2 Shape "inner" AttributeEnd
            Shape "middle"
        AttributeEnd
        Shape "outer")");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const auto s = All(parsed->scene.shapes);
    ASSERT_EQ(s.size(), 3u);
    EXPECT_FALSE(s[0].reverseOrientation);
    EXPECT_EQ(s[0].worldFromObject[0],
              Transform::Translate({1, 0, 0}) * *Transform::Scale({2, 2, 2}));
    EXPECT_EQ(s[1].worldFromObject[0], Transform::Translate({1, 0, 0}));
    EXPECT_EQ(s[1].material, 0);
    EXPECT_EQ(s[1].params.size(), 1u);
    EXPECT_TRUE(s[2].reverseOrientation);
    EXPECT_TRUE(s[2].worldFromObject[0] == Transform());
    EXPECT_EQ(s[2].material, -1);
    EXPECT_EQ(s[2].colorSpace, &RGBColorSpace::sRGB());
    EXPECT_TRUE(s[2].params.empty());
}

TEST(State, TransformBeginIsAttributeBeginWithOneWarning) {
    const auto parsed = ParseWorld(
        "TransformBegin Translate 1 0 0 TransformEnd\n"
        "TransformBegin TransformEnd Shape \"a\"");
    EXPECT_EQ(parsed->Messages(),
              Texts{"test.pbrt:2:1: TransformBegin and TransformEnd are read as AttributeBegin and "
                    "AttributeEnd: pbrt-v4 has only these"});
    EXPECT_FALSE(parsed->log.HasErrors());
    EXPECT_TRUE(All(parsed->scene.shapes).at(0).worldFromObject[0] == Transform());
}

TEST(State, AttributesFollowTheOwnParametersOfEachKind) {
    const auto parsed = ParseWorld(R"(
        Attribute "shape" "float a" 1 "float b" 2
        Attribute "light" "float c" 3
        Attribute "material" "float d" 4
        Attribute "texture" "float e" 5
        Attribute "medium" "float f" 6
        AttributeBegin
            Attribute "shape" "float a" 7
            Shape "s" "float own" 0
        AttributeEnd
        LightSource "l"  AreaLightSource "al"  Shape "s"
        Material "m"  MakeNamedMaterial "nm" "string type" "m"
        Texture "t" "float" "c")");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const auto names = [](const Entity &e) {
        std::string text;
        for (const ParsedParameter &p : e.params) {
            text += p.name + std::to_string(int(p.floats.at(0)));
            EXPECT_EQ(p.mayBeUnused, p.name != "own");
        }
        return text;
    };
    const SceneDescription &d = parsed->scene;
    EXPECT_EQ(names(All(d.shapes).at(0)), "own0a1b2a7");
    EXPECT_EQ(names(All(d.shapes).at(1)), "a1b2");
    EXPECT_EQ(names(d.lights.at(0)), "c3");
    EXPECT_EQ(names(*All(d.shapes)[1].areaLight), "c3");
    EXPECT_EQ(names(All(d.materials).at(0)), "d4");
    EXPECT_EQ(names(d.namedMaterials.at(0)), "d4");
    EXPECT_EQ(names(d.textures.at(0)), "e5");
}

TEST(State, AttributesBeforeWorldBeginHold) {
    const auto parsed = Parse("Attribute \"shape\" \"float a\" 1 WorldBegin Shape \"s\"");
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(All(parsed->scene.shapes).at(0).params.size(), 1u);
}

TEST(State, MatrixInverseBelongsToTheMatrix) {
    const Transform t = ShapeTransform("Rotate 30 1 2 3 Translate 1 2 3 Scale 2 3 4");
    ExpectNear((t * t.Inverse()).Matrix(), Transform().Matrix());
}

}  // namespace
}  // namespace pbrt
