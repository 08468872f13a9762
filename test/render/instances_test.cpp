// Objects look the same whether they are instanced, nested or written out, at rest and in motion.

#include <fmt/format.h>

#include <cmath>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

double MeanDifference(const Image &a, const Image &b) {
    EXPECT_EQ(a.Data().size(), b.Data().size());
    double sum = 0;
    for (size_t i = 0; i < a.Data().size(); ++i)
        sum += std::abs(a.Data()[i] - b.Data()[i]);
    return sum / double(a.Data().size());
}

/// A brushed patch with normals and tangents of its own, a sphere and a triangle with its own uv:
/// the stretched highlights show their shading frames.
constexpr char kModel[] = R"(
Material "conductor" "float uroughness" .4 "float vroughness" .02 "bool remaproughness" false
Shape "trianglemesh" "point3 P" [ -.5 -.5 0  .5 -.5 0  .5 .5 .1  -.5 .5 0 ]
    "integer indices" [ 0 1 2 0 2 3 ]
    "normal N" [ -.2 0 1  .2 0 1  .2 .1 1  -.2 .1 1 ] "vector3 S" [ 1 0 0  1 .3 0  1 0 0  1 -.3 0 ]
AttributeBegin
  Translate .9 0 0
  Rotate 30 0 1 1
  Shape "sphere" "float radius" .4 "float zmax" .3
AttributeEnd
ReverseOrientation
Shape "trianglemesh" "point3 P" [ -1 -1 0  -.4 -1 .2  -.8 -.3 0 ] "point2 uv" [ 0 0 0 2 1 0 ]
Shape "bilinearmesh" "point3 P" [ .3 -1 0  .9 -1 .1  .2 -.5 .2  1 -.6 -.1 ]
)";

std::string Scene(const std::string &world, const std::string &before = "", int samples = 16,
                  int size = 64) {
    return fmt::format(R"({}
Scale -1 1 1  # x to the right as seen from +z
LookAt 0 0 5  0 0 0  0 1 0
Camera "orthographic" "float screenwindow" [ -2 2 -2 2 ]
Sampler "zsobol" "integer pixelsamples" {}
PixelFilter "box" "float xradius" .5 "float yradius" .5
Integrator "path" "integer maxdepth" 3
Film "rgb" "integer xresolution" {} "integer yresolution" {} "string filename" "a.exr"
WorldBegin
{}
)",
                       before, samples, size, size, world);
}

const std::string kLamp = R"(LightSource "point" "point3 from" [ 1 2 4 ] "float scale" 100
LightSource "distant" "point3 from" [ -1 0 1 ] "point3 to" [ 0 0 0 ] "float scale" 3
)";

TEST(InstancedPictures, NestedObjectsLookLikeTheirCopies) {
    // Placed twice: as they are, mirrored and stretched inside a turned group.
    const std::string group = "Rotate 40 0 1 0\nTranslate -.5 .8 0\n";
    const std::string inner = "Translate .2 -1.2 0\nScale -.8 1.3 .7\nRotate 20 1 0 0\n";
    const std::string nested =
        "ObjectBegin \"model\"\n" + std::string(kModel) +
        "ObjectEnd\nObjectBegin \"group\"\nObjectInstance \"model\"\nAttributeBegin\n" + inner +
        "ObjectInstance \"model\"\nAttributeEnd\nObjectEnd\nAttributeBegin\n" + group +
        "ObjectInstance \"group\"\nAttributeEnd\n";
    const std::string copies = "AttributeBegin\n" + group + "AttributeBegin\n" + kModel +
                               "AttributeEnd\nAttributeBegin\n" + inner + kModel +
                               "AttributeEnd\nAttributeEnd\n";
    const Image a = RenderText(Scene(kLamp + nested)), b = RenderText(Scene(kLamp + copies));
    EXPECT_GT(Mean(b)[1], 0.05);
    // The same paths but where rounding decides at an edge or a bounce's direction.
    EXPECT_LT(MeanDifference(a, b), 0.02 * Mean(b)[1]);
    const Image upright =
        RenderText(Scene(kLamp + "AttributeBegin\n" + group + "AttributeBegin\n" + kModel +
                         "AttributeEnd\nAttributeBegin\nTranslate .2 -1.2 0\nScale .8 1.3 .7\n" +
                         kModel + "AttributeEnd\nAttributeEnd\n"));
    EXPECT_GT(MeanDifference(upright, b), 0.2 * Mean(b)[1]);
}

/// A white square of side 1 that moves from x = -1.5 to x = 0.5 (its left edge) under light from
/// the camera's side; `move` is the motion of what follows it.
const std::string kWhite = R"(LightSource "distant" "point3 from" [ 0 0 1 ] "point3 to" [ 0 0 0 ]
Material "diffuse" "rgb reflectance" [ 1 1 1 ]
)";
const std::string kMove = "ActiveTransform EndTime\nTranslate 2 0 0\nActiveTransform All\n";
const std::string kSquare =
    "Shape \"bilinearmesh\" \"point3 P\" [ -1.5 -1 0  -.5 -1 0  -1.5 1 0  -.5 1 0 ]\n";

/// Mean over the rows that the square covers throughout, per column, of a picture of [-2, 2]^2.
std::vector<double> Columns(const Image &image) {
    const Point2i n = image.Resolution();
    std::vector<double> mean(size_t(n.x), 0);
    for (int x = 0; x < n.x; ++x)
        for (int y = n.y / 4; y < 3 * n.y / 4; ++y)
            mean[size_t(x)] += image.Get({x, y}, 1) / double(n.y / 2);
    return mean;
}

/// Fraction of the shutter's time for which a column of pixels is covered, the square's left edge
/// being at -1.5 + 2 position(u) at the fraction u of that time.
template <typename Position>
double Coverage(int column, int nColumns, Position position) {
    constexpr int n = 400;
    double covered = 0;
    const double width = 4. / nColumns, left = -2 + column * width;
    for (int i = 0; i < n; ++i) {
        const double edge = -1.5 + 2 * position((i + 0.5) / n);
        covered += std::max(0., std::min(left + width, edge + 1) - std::max(left, edge)) / n;
    }
    return covered / width;
}

template <typename Position>
void ExpectBlur(const std::string &world, Position position, const std::string &before = "") {
    constexpr int kSize = 32, kSamples = 64;
    const Image image = RenderText(Scene(kWhite + world, before, kSamples, kSize));
    const Image still = RenderText(Scene(kWhite + kSquare, before, 4, kSize));
    const double bright = Columns(still)[size_t(kSize / 4)];
    ASSERT_GT(bright, 0.1);
    const std::vector<double> got = Columns(image);
    for (int x = 0; x < kSize; ++x) {
        const double expected = Coverage(x, kSize, position);
        // A sample is covered or not: at most 1/2 over the root of 16 x 64 of them; 4 sigma, and
        // stratified samples do better.
        EXPECT_NEAR(got[size_t(x)] / bright, expected, 0.0625) << "column " << x;
    }
}

double Throughout(double u) {
    return u;
}

TEST(MotionBlur, OfAShape) {
    ExpectBlur(kMove + kSquare, Throughout);
}

TEST(MotionBlur, OfAnInstance) {
    ExpectBlur("ObjectBegin \"o\"\n" + kSquare + "ObjectEnd\n" + kMove + "ObjectInstance \"o\"\n",
               Throughout);
}

TEST(MotionBlur, OfANestedInstance) {
    // Half of the way by the inner use, half by the outer one, which is turned round.
    const std::string back = "ActiveTransform EndTime\nTranslate -1 0 0\nActiveTransform All\n";
    const std::string on = "ActiveTransform EndTime\nTranslate 1 0 0\nActiveTransform All\n";
    ExpectBlur("AttributeBegin\nObjectBegin \"o\"\nRotate 180 0 0 1\n" + kSquare +
                   "ObjectEnd\nAttributeEnd\nAttributeBegin\nObjectBegin \"p\"\n" + back +
                   "ObjectInstance \"o\"\nObjectEnd\nAttributeEnd\n" + on +
                   "Rotate 180 0 0 1\nObjectInstance \"p\"\n",
               Throughout);
}

TEST(MotionBlur, OfAMovingShapeInAnObject) {
    ExpectBlur("AttributeBegin\nObjectBegin \"o\"\n" + kMove + kSquare +
                   "ObjectEnd\nAttributeEnd\nObjectInstance \"o\"\n",
               Throughout);
    // What rests beside it stays.
    ExpectBlur("AttributeBegin\nObjectBegin \"o\"\n" + kSquare + kMove + "Translate 0 100 0\n" +
                   kSquare +
                   "ObjectEnd\nAttributeEnd\n"
                   "ObjectInstance \"o\"\n",
               [](double) { return 0.; });
}

TEST(MotionBlur, TurningKeepsSizes) {
    // A quarter turn about the square's own center: at a distance r from it the fraction of time
    // in the square is that of angles at which a point there lies inside.
    constexpr int kSize = 33, kSamples = 128;
    const std::string square =
        "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0  1 -1 0  -1 1 0  1 1 0 ]\n";
    const std::string turn = "ActiveTransform EndTime\nRotate 90 0 0 1\nActiveTransform All\n";
    const Image image = RenderText(Scene(kWhite + turn + square, "", kSamples, kSize));
    // At rest the square covers a quarter of the picture.
    const double bright = 4 * Mean(RenderText(Scene(kWhite + square, "", 64, kSize)))[1];
    double sum = 0, ringSum = 0, ringExpected = 0;
    int ring = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const double r = std::hypot(x - 16, y - 16) * 4 / kSize;
            const double covered = image.Get({x, y}, 1) / bright;
            sum += covered * 16 / (kSize * kSize);
            if (r < 1.1 || r > 1.3) continue;
            // Each of the four sides cuts an arc of 2 acos(1 / r) off the circle.
            ringExpected += 1 - 4 * std::acos(1 / r) * 2 / (2 * Pi);
            ringSum += covered;
            ++ring;
        }
    // The whole area never changes: 4 sigma of 1/2 over the root of 128 samples in each of the
    // about 300 pixels that are now in, now out.
    EXPECT_NEAR(sum, 4, 4 * 0.5 / std::sqrt(128 * 300) * 300 * 16 / (kSize * kSize));
    EXPECT_GT(ring, 50);
    EXPECT_NEAR(ringSum / ring, ringExpected / ring, 0.02);
}

TEST(MotionBlur, FollowsTransformTimes) {
    const auto moves = [](double start, double end) {
        return [=](double u) { return std::clamp((u - start) / (end - start), 0., 1.); };
    };
    ExpectBlur(kMove + kSquare, moves(0.5, 1.5), "TransformTimes .5 1.5\n");
    ExpectBlur(kMove + kSquare, moves(-1, 0.25), "TransformTimes -1 .25\n");
    ExpectBlur(
        kMove + kSquare, [](double) { return 1.; }, "TransformTimes -2 -1\n");
    ExpectBlur(
        kMove + kSquare, [](double u) { return u < 0.25 ? 0. : 1.; }, "TransformTimes .25 .25\n");
}

}  // namespace
}  // namespace pbrt::test
