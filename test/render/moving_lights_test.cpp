// Area lights in motion: found by rays and by light sampling alike, and in the mean over the
// shutter's time as bright as lights at rest on their way.

#include <fmt/format.h>

#include <cmath>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// A floor and a ball under what `light` adds, of which the camera sees a part.
std::string Scene(const std::string &light, int spp) {
    return fmt::format(R"(
LookAt 0 -6 4  0 0 1  0 0 1
Camera "perspective" "float fov" 40
Sampler "zsobol" "integer pixelsamples" {}
Film "rgb" "integer xresolution" 16 "integer yresolution" 16
Integrator "path" "integer maxdepth" 2
WorldBegin
Material "diffuse" "rgb reflectance" [ .6 .6 .6 ]
Shape "bilinearmesh" "point3 P" [ -5 -5 0  5 -5 0  -5 5 0  5 5 0 ]
Shape "sphere" "float radius" .5
AttributeBegin
AreaLightSource "diffuse" "rgb L" [ 4 4 4 ]
{}
AttributeEnd
)",
                       spp, light);
}

/// A way of the light's space, and where on it something is at the time.
struct Way {
    std::string start, end;
    std::string (*at)(double time);
};
const Way kSlide{"Translate -2 0 2", "Translate 2 1 3",
                 [](double t) { return fmt::format("Translate {} {} {}", 4 * t - 2, t, 2 + t); }};
const Way kTurn{"Translate 0 0 2 Rotate 0 1 0 0", "Translate 0 0 2 Rotate 170 1 0 0",
                [](double t) { return fmt::format("Translate 0 0 2 Rotate {} 1 0 0", 170 * t); }};
const Way kGrow{"Translate 0 0 2 Scale .5 1 1", "Translate 0 0 2 Scale 2 1.5 .5", [](double t) {
                    return fmt::format("Translate 0 0 2 Scale {} {} {}", .5 + 1.5 * t, 1 + .5 * t,
                                       1 - .5 * t);
                }};

std::string Moving(const Way &way, const std::string &shape) {
    return fmt::format(
        "ActiveTransform StartTime {}\nActiveTransform EndTime {}\n"
        "ActiveTransform All\n{}",
        way.start, way.end, shape);
}

struct Case {
    const char *name;
    Way way;
    std::string shape;
};
const Case kCases[] = {
    {"a patch that slides, downwards", kSlide,
     R"(ReverseOrientation Shape "bilinearmesh" "point3 P" [ -.5 -.5 0  .5 -.5 0  -.5 .5 0  .5 .5 0 ])"},
    {"two triangles that turn, of both sides", kTurn,
     R"(AreaLightSource "diffuse" "rgb L" [ 4 4 4 ] "bool twosided" true
        Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ]
        "point3 P" [ -.5 -.5 0  .5 -.5 0  .7 .5 .2  -.5 .5 0 ])"},
    {"a disk that turns", kTurn, R"(Shape "disk" "float radius" .7)"},
    {"a sphere that is stretched", kGrow, R"(Shape "sphere" "float radius" .4)"},
    {"a cylinder with holes", kGrow, R"(Shape "cylinder" "float radius" .3 "float alpha" .6)"},
};

class MovingLights : public testing::TestWithParam<Case> {};

/// Mean of a picture and its standard error, over seeds.
std::pair<double, double> Estimate(const std::string &text, LightStrategy strategy) {
    constexpr int kRuns = 8;
    double sum = 0, squares = 0;
    for (int seed = 0; seed < kRuns; ++seed) {
        const double v = Mean(RenderText(text, {.seed = seed, .strategy = strategy}))[1];
        sum += v, squares += v * v;
    }
    const double mean = sum / kRuns;
    return {mean, std::sqrt(std::max(0., squares / kRuns - mean * mean) / (kRuns - 1))};
}

TEST_P(MovingLights, AreFoundByRaysAndBySamplesAlike) {
    const std::string text = Scene(Moving(GetParam().way, GetParam().shape), 64);
    const auto both = Estimate(text, LightStrategy::Both),
               lights = Estimate(text, LightStrategy::LightsOnly),
               bsdf = Estimate(text, LightStrategy::BSDFOnly);
    ASSERT_GT(both.first, 0.01);
    // Student's t with 14 degrees of freedom, ten comparisons at 0.001 each: 4.14 sigma.
    EXPECT_NEAR(lights.first, both.first, 4.14 * std::hypot(lights.second, both.second));
    EXPECT_NEAR(bsdf.first, both.first, 4.14 * std::hypot(bsdf.second, both.second));
    // These say something.
    EXPECT_LT(lights.second / lights.first, 0.03);
    EXPECT_LT(bsdf.second / bsdf.first, 0.05);
}

TEST_P(MovingLights, ShineAsManyThatRestOnTheirWay) {
    const auto &[name, way, shape] = GetParam();
    constexpr int kPlaces = 64;
    double rest = 0;
    for (int i = 0; i < kPlaces; ++i)
        rest += Mean(RenderText(Scene(way.at((i + .5) / kPlaces) + "\n" + shape, 16),
                                {.seed = 100 + i}))[1] /
                kPlaces;
    const auto moving = Estimate(Scene(Moving(way, shape), 64), LightStrategy::Both);
    // 64 places leave 1e-3 of the sum; the noise of both is of the same size.
    EXPECT_NEAR(moving.first / rest, 1, 4e-3 + 4 * M_SQRT2 * moving.second / rest);
}

INSTANTIATE_TEST_SUITE_P(All, MovingLights, testing::ValuesIn(kCases));

}  // namespace
}  // namespace pbrt::test
