// The model's closed forms against the tracer of true ellipses. See CriticalSigmas for the
// significance; this file makes 17 400 comparisons: 65 for each of 268 pairs of shape and
// direction.

#include <gtest/gtest.h>

#include <sstream>

#include "oracle/model_side.h"
#include "oracle/row_tracer.h"

namespace pbrt::oracle {
namespace {

using feather::Shape;

struct Angles {
    double theta, phi;
};
constexpr Angles kDirections[] = {{0, 0},    {20, 10},  {30, 180},  {45, 90},  {45, 225},
                                  {60, 0},   {60, 135}, {70, 300},  {75, 180}, {80, 80},
                                  {85, 350}, {87, 92},  {89.5, 200}};

std::ostream &operator<<(std::ostream &out, Vec3 w) {
    return out << "(" << w.x << ", " << w.y << ", " << w.z << ")";
}

/// Model and tracer for one shape; the film lies over melanin that reflects everything.
class Pair {
  public:
    explicit Pair(const Shape &shape)
        : shape(shape),
          reflecting(shape, 0),
          scattering(shape, 1),
          row(BentRowOf(shape)),
          optics{{ModelSide::kLambda, shape.thickness, ModelSide::kEta}, 1} {}

    struct Totals {
        double r, trt;  ///< in standard errors
    };

    /// Compares all that the tracer estimates for light from w, `samples` rays per replicate.
    Totals Compare(Vec3 w, int samples, std::uint64_t seed) const {
        const DirectionBins reflected = reflecting.ReflectedBins(w, 8, 3);
        const DirectionBins scattered = scattering.ScatteredBins(w, 6, 2);
        const auto r = reflecting.IntegrateR(w, reflected, seed, samples);
        const auto trt = scattering.IntegrateTRT(w, scattered, seed + 1, samples / 16);
        const RowLight light =
            RowTracer(row, optics, reflected, scattered).Trace(w, {seed + 2, samples});
        std::ostringstream where;
        where << shape << " w " << w;

        const Estimate gap{reflecting.Gap(w), 0};
        ExpectSame(gap, light.gap, where.str() + " gap fraction");
        ExpectSame(r.facets + gap, {1, 0}, where.str() + " gap and visible facets");
        ExpectSame(r.all, light.single, where.str() + " R");
        ExpectSame(trt.all, light.pigment, where.str() + " TRT");
        ExpectSameBins(r.facetBins, light.facets, where.str() + " visible facets");
        ExpectSameBins(r.bins, light.singleBins, where.str() + " R");
        ExpectSameBins(trt.bins, light.pigmentBins, where.str() + " TRT");

        const Estimate all = r.all + trt.all + gap;
        EXPECT_LE(all.mean - CriticalSigmas() * all.error, 1) << where.str();
        return {Sigmas(r.all, light.single), Sigmas(trt.all, light.pigment)};
    }

  private:
    static void ExpectSameBins(const std::vector<Estimate> &a, const std::vector<Estimate> &b,
                               const std::string &what) {
        for (std::size_t i = 0; i < a.size(); ++i)
            ExpectSame(a[i], b[i], what + " bin " + std::to_string(i));
    }

    Shape shape;
    ModelSide reflecting, scattering;
    BentRow row;
    FilmOverMelanin optics;
};

class ClosedForms : public testing::TestWithParam<Shape> {};

// Besides each comparison, the sum of a shape's deviations must not be too far from 0 either: this
// would show an error of the same sign in all directions that is too small for any one.
TEST_P(ClosedForms, EqualTheTracer) {
    const Pair pair(GetParam());
    double r = 0, trt = 0, n = 0;
    for (const Angles a : kDirections)
        for (const Vec3 w : {Towards(a.theta, a.phi), -Towards(a.theta, a.phi)}) {
            const Pair::Totals totals = pair.Compare(w, 1024, 1000 + 10 * std::uint64_t(n));
            r += totals.r;
            trt += totals.trt;
            ++n;
        }
    EXPECT_LE(std::abs(r) / std::sqrt(n), CriticalSigmas());
    EXPECT_LE(std::abs(trt) / std::sqrt(n), CriticalSigmas());
}

INSTANTIATE_TEST_SUITE_P(Shapes, ClosedForms,
                         testing::Values(Shape{}, Shape{.aspect = 1}, Shape{.spacing = 2.5},
                                         Shape{.spacing = 0.3}, Shape{.tilt = -0.8},
                                         Shape{.tilt = 0.3}, Shape{.opening = 0.1571},
                                         Shape{.opening = 0.9}));

Vec3 AnyDirection(feather::Dice &dice, double steepest) {
    const double theta = dice.Uniform(0, steepest);
    return Towards(theta, dice.Uniform(0, 360));
}

TEST(CornerShape, EqualsTheTracer) {
    constexpr double right = std::numbers::pi / 2;
    const Shape shapes[] = {
        {.aspect = 0.001},
        {.aspect = 1000},
        {.spacing = 0.01, .aspect = 1},
        {.spacing = 50},
        {.spacing = 2, .tilt = 0},               // touching
        {.spacing = 2, .tilt = 0, .aspect = 1},  // touching circles
        {.tilt = right},
        {.tilt = -right},
        {.spacing = 3, .tilt = right, .aspect = 4},
        {.opening = 0},
        {.opening = 1.5},
        {.spacing = 2.5, .tilt = -0.8, .opening = 1.5},
        {.thickness = 20000},
        {.thickness = 0},
    };
    feather::Dice dice(41);
    std::uint64_t seed = 4000;
    for (const Shape &shape : shapes)
        for (const double side : {1, -1})
            Pair(shape).Compare(side * AnyDirection(dice, 88), 512, seed += 10);
}

TEST(AnyShape, EqualsTheTracer) {
    feather::Dice dice(40);
    for (int k = 0; k < 60; ++k) {
        const Shape shape = dice.AnyShape();
        const Vec3 w = AnyDirection(dice, 89);
        Pair(shape).Compare(k % 2 ? w : -w, 512, 5000 + 10 * std::uint64_t(k));
    }
}

}  // namespace
}  // namespace pbrt::oracle
