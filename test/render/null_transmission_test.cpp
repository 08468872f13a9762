// Light passes the gaps of feather surfaces.

#include <fmt/format.h>

#include "pbrt/feather/barbule.h"
#include "pbrt/materials/feather_cells.h"
#include "render/render_text.h"

namespace pbrt::test {
namespace {

// A wide spacing: a large gap, some reflection.
constexpr char kVane[] = "Material \"featherbarbule\" \"float spacing\" 4 \"float tilt\" -0.3 ";

std::string Layer(float z) {
    return fmt::format(
        "Shape \"bilinearmesh\" \"point3 P\" [ -40 -40 {0}  40 -40 {0}  -40 40 {0}  "
        "40 40 {0} ]\n",
        z);
}

std::string Scene(const std::string &world, int maxDepth, int spp) {
    return fmt::format(
        "LookAt 0 0 0  0 0 -1  0 1 0\nCamera \"perspective\" \"float fov\" 2\n"
        "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16\n"
        "Sampler \"zsobol\" \"integer pixelsamples\" {}\n"
        "Integrator \"path\" \"integer maxdepth\" {}\nWorldBegin\n{}",
        spp, maxDepth, world);
}

/// A diffuse floor at z = -10 seen straight on from the origin, lit by a point light at `x`, 5
/// above it, with whatever stands between them.
std::string LitFloor(const std::string &between) {
    return "AttributeBegin\nMaterial \"diffuse\" \"spectrum reflectance\" [ 300 1 900 1 ]\n" +
           Layer(-10) +
           "AttributeEnd\nLightSource \"point\" \"spectrum I\" [ 300 1 900 1 ] "
           "\"point3 from\" [ 3 0 -5 ] \"float scale\" 100\n" +
           between;
}

/// Fraction that one layer of kVane lets through along w, in the frame of Layer: x is dp/du.
double GapOf(Vector3f w, double tilt = -0.3) {
    using namespace feather;
    BarbuleParams<double> params;
    params.spacing = 4;
    params.tilt = Radian<double>{tilt};
    Optics<double, 1> optics{{550}, {1.55}, {0.07}};
    return Barbule<double, 1>(params, optics).GapFraction({w.x, w.y, w.z});
}

TEST(Gaps, PointLightThroughTwoLayers) {
    // Camera rays must not cross the layers: they stand beside the view, between floor and light.
    const std::string layers = fmt::format("{}\n{}{}", kVane, Layer(-7), Layer(-8));
    const auto seen = [&](const std::string &between) {
        // Depth 1: direct light of the floor only; the camera sees the floor through both layers.
        return Mean(RenderText(Scene(LitFloor(between), 1, 64)))[1];
    };
    const double open = seen(""), through = seen(layers);
    // The view passes both layers along z, the light both along its direction: T(z)^2 T(w)^2.
    const Vector3f w = Normalize(Vector3f{3, 0, 5});
    const double expected = open * Sqr(GapOf({0, 0, 1})) * Sqr(GapOf(w));
    ASSERT_GT(expected, 0);
    // What the layers scatter towards the camera (R and TRT of two dark vanes, once) adds a little;
    // depth 1 leaves it in, so look at the floor with the layers black: eta = 1 and no melanin.
    const std::string black = fmt::format(
        "{} \"spectrum eta\" [ 300 1 900 1 ] \"spectrum melanin\" [ 300 0 900 0 ]\n{}{}", kVane,
        Layer(-7), Layer(-8));
    // 16384 samples of a Bernoulli passage of about 0.25: standard error 1.4 %; bound 4 sigma.
    EXPECT_NEAR(seen(black) / expected, 1, 0.056);
    EXPECT_GE(through, expected * 0.94);
}

/// A layer that is one large cell, of another tilt and turned: shadow rays pass it in its frame, as
/// those of the camera do.
TEST(Gaps, OfACell) {
    const std::string black =
        "\"spectrum eta\" [ 300 1 900 1 ] \"spectrum melanin\" [ 300 0 900 0 ]\n";
    const std::string cell = kVane +
                             std::string(
                                 "\"float celltilt\" .3 \"float cellbend\" .3 "
                                 "\"float cellsacross\" .001 \"float cellsalong\" .001 ") +
                             black;
    const auto seen = [&](const std::string &between) {
        return Mean(RenderText(Scene(LitFloor(between), 1, 1024)))[1];
    };
    const FeatherCell first = FeatherCells::Of(0, 0, 0, 0);
    const float bend = 0.3f * first.bend, c = std::cos(bend), s = std::sin(bend);
    const auto gap = [&](Vector3f w) {
        return GapOf({w.x, c * w.y - s * w.z, s * w.y + c * w.z}, -0.3 + 0.3 * double(first.tilt));
    };
    const Vector3f z{0, 0, 1}, w = Normalize(Vector3f{3, 0, 5});
    const double expected = seen("") * gap(z) * gap(w);
    // Without the turn it would be another by 5 % or more.
    EXPECT_GT(std::abs(GapOf(z) * GapOf(w) / (gap(z) * gap(w)) - 1), 0.05);
    // 262144 samples of a passage of about a half: standard error 0.3 %; bound 4 sigma.
    EXPECT_NEAR(seen(cell + Layer(-7)) / expected, 1, 0.012);
}

TEST(Gaps, AnyNumberOfLayersNoCap) {
    // 60 layers that are nearly all gap.
    std::string layers =
        "Material \"featherbarbule\" \"float spacing\" 1000 \"spectrum eta\" [ 300 1 900 1 ] "
        "\"spectrum melanin\" [ 300 0 900 0 ]\n";
    for (int i = 0; i < 60; ++i)
        layers += Layer(-6 - 0.05f * i);
    const double open = Mean(RenderText(Scene(LitFloor(""), 1, 16)))[1];
    const double through = Mean(RenderText(Scene(LitFloor(layers), 1, 64)))[1];
    feather::BarbuleParams<double> params;
    params.spacing = 1000;
    const feather::Barbule<double, 1> vane(params, {{550}, {1.55}, {0.07}});
    const double expected =
        open * std::pow(vane.GapFraction({0, 0, 1}), 60) *
        std::pow(vane.GapFraction({3 / std::sqrt(34.), 0, 5 / std::sqrt(34.)}), 60);
    EXPECT_NEAR(through / expected, 1, 0.02);
}

/// kVane in holes of an opaque layer, or the other way round, one kind of hit in three a vane.
std::string MixedVane(const std::string &opaque) {
    return "MakeNamedMaterial \"vane\" \"string type\" \"featherbarbule\" \"float spacing\" 4 "
           "\"float tilt\" -0.3 \"spectrum eta\" [ 300 1 900 1 ] \"spectrum melanin\" [ 300 0 900 "
           "0 ]\n"
           "MakeNamedMaterial \"opaque\" \"string type\" " +
           opaque +
           "\nMakeNamedMaterial \"inner\" \"string type\" \"mix\" \"string materials\" [ \"vane\" "
           "\"opaque\" ] \"float amount\" .5\n"
           "Material \"mix\" \"string materials\" [ \"opaque\" \"inner\" ] \"float amount\" "
           ".666666667 ";
}

/// Layers between an area light and a floor, looked at from the light's side and in part through
/// them.
std::string LitVane(const std::string &vane) {
    return "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [ 20 20 20 ]\n"
           "Shape \"bilinearmesh\" \"point3 P\" [ -2 -2 -3  -2 2 -3  -1 -2 -3  -1 2 -3 ]\n"
           "AttributeEnd\n"
           "AttributeBegin\nMaterial \"diffuse\" \"rgb reflectance\" [ .8 .8 .8 ]\n" +
           Layer(-10) + "AttributeEnd\n" + vane + "\n" + Layer(-7) + Layer(-6);
}

void ExpectStrategiesToAgree(const std::string &text) {
    constexpr int kRuns = 8;
    const auto estimate = [&](LightStrategy strategy) {
        double sum = 0, sumSqr = 0;
        for (int seed = 0; seed < kRuns; ++seed) {
            const double v = Mean(RenderText(text, {.seed = seed, .strategy = strategy}))[1];
            sum += v, sumSqr += v * v;
        }
        const double mean = sum / kRuns;
        return std::pair(mean, std::sqrt((sumSqr / kRuns - mean * mean) / (kRuns - 1)));
    };
    const auto both = estimate(LightStrategy::Both), lights = estimate(LightStrategy::LightsOnly),
               bsdf = estimate(LightStrategy::BSDFOnly);
    // Two comparisons, Student's t with 14 degrees of freedom at 0.005 each: 3.33 sigma.
    EXPECT_NEAR(lights.first, both.first, 3.33 * std::hypot(lights.second, both.second));
    EXPECT_NEAR(bsdf.first, both.first, 3.33 * std::hypot(bsdf.second, both.second));
    EXPECT_LT(lights.second / lights.first, 0.02);
    EXPECT_LT(bsdf.second / bsdf.first, 0.05);
}

TEST(Gaps, LightSamplingAndBSDFSamplingAgree) {
    ExpectStrategiesToAgree(Scene(LitVane(kVane), 3, 256));
}

TEST(Gaps, LightSamplingAndBSDFSamplingAgreeOnMixes) {
    ExpectStrategiesToAgree(Scene(
        LitVane(MixedVane("\"diffusetransmission\" \"rgb reflectance\" [ .3 .6 .2 ]")), 3, 256));
}

/// Shadow rays take what the choice of a path's hits passes in the mean.
TEST(Gaps, MixesPassTheirShare) {
    const std::string black = "\"diffuse\" \"spectrum reflectance\" [ 300 0 900 0 ]";
    const auto seen = [&](const std::string &between) {
        return Mean(RenderText(Scene(LitFloor(between), 1, 1024)))[1];
    };
    const Vector3f w = Normalize(Vector3f{3, 0, 5});
    const double expected = seen("") * GapOf({0, 0, 1}) * GapOf(w) / 9;
    ASSERT_GT(expected, 0);
    // 262144 samples of a passage of about 0.17: standard error 0.43 %; bound 4 sigma.
    EXPECT_NEAR(seen(MixedVane(black) + Layer(-7)) / expected, 1, 0.018);
}

}  // namespace
}  // namespace pbrt::test
