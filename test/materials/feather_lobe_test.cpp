// Cells of a feather's vane: their mean, and the samples of one.

#include <cmath>
#include <numbers>

#include "feather/model.h"
#include "materials/vane_text.h"
#include "pbrt/util/rng.h"
#include "support/chi_square.h"
#include "support/sphere_bins.h"

namespace pbrt::test {
namespace {

/// Density of the sum of four uniform numbers, of variance 1: a cubic spline.
double BellDensity(double x) {
    const double t = std::abs(x) / std::numbers::sqrt3;
    const double spline = t < 1   ? (4 - 6 * t * t + 3 * t * t * t) / 6
                          : t < 2 ? std::pow(2 - t, 3) / 6
                                  : 0;
    return spline / std::numbers::sqrt3;
}

// The far lobe is the mean over cells: of 1e5 of them against a sum over the density of their
// numbers, made without cells.
TEST(FeatherCells, MeanIsThatOverTheBell) {
    const auto made = Vane(kGrid + kVaried);
    const auto &material = made.As<FeatherBarbuleMaterial>();
    const Vector3f wo = Normalize(Vector3f{-.25f, .1f, .9f}),
                   wi = Normalize(Vector3f{.1f, -.04f, 1});
    constexpr int kCells = 100000, kSteps = 48;
    std::array<double, 4> mean{}, square{}, expected{};
    for (int k = 0; k < kCells; ++k) {
        const auto ctx = AtUV((float(k % 400) + .5f) / 40, (float(k / 400) + .5f) / 25);
        const Frame frame = material.TurnFrame(kStraight, ctx);
        const auto f =
            material.GetBxDF(ctx, kLambda).f(frame.ToLocal(wo), frame.ToLocal(wi), kMode);
        for (int i = 0; i < 4; ++i) {
            mean[size_t(i)] += double(f[i]) / kCells;
            square[size_t(i)] += double(f[i]) * f[i] / kCells;
        }
    }
    const double most = 2 * std::numbers::sqrt3, step = 2 * most / kSteps;
    const auto number = [&](int k) { return -most + (k + 0.5) * step; };
    for (int a = 0; a < kSteps; ++a)
        for (int b = 0; b < kSteps; ++b) {
            const feather::Shape shape{.thickness = 590 + 10 * number(a),
                                       .tilt = -0.35 + 0.05 * number(b)};
            const auto barbule = feather::BarbuleOf<float>(shape);
            for (int c = 0; c < kSteps; ++c) {
                const float bend = float(0.03 * number(c));
                const auto local = [&](Vector3f w) {
                    return feather::Direction<float>{w.x,
                                                     std::cos(bend) * w.y - std::sin(bend) * w.z,
                                                     std::sin(bend) * w.y + std::cos(bend) * w.z};
                };
                const auto f = barbule.f(barbule.SeenFrom(local(wo)), local(wi));
                const double weight = BellDensity(number(a)) * BellDensity(number(b)) *
                                      BellDensity(number(c)) * step * step * step;
                for (size_t i = 0; i < 4; ++i)
                    expected[i] += weight * double(f[i]);
            }
        }
    for (size_t i = 0; i < 4; ++i) {
        const double error = std::sqrt((square[i] - mean[i] * mean[i]) / kCells);
        // f is cut off where a facet is hidden or off the arc: half a step of the bend there.
        EXPECT_NEAR(mean[i], expected[i], 5 * error + 0.01 * expected[i]);
        EXPECT_LT(error, 0.005 * expected[i]);
    }
}

// One cell, turned: what is drawn in its frame and counted in the world's follows its density.
TEST(FeatherCells, SamplesOfATurnedCell) {
    const auto made =
        Vane("\"float spacing\" 2.5 \"float celltilt\" .2 \"float cellbend\" .3" + kGrid);
    const auto &material = made.As<FeatherBarbuleMaterial>();
    const TextureEvalContext ctx = AtUV(0.01f, 0.01f);
    const Frame frame = material.TurnFrame(kStraight, ctx);
    EXPECT_LT(frame.z.z, 0.98f);
    const FeatherBarbuleBxDF bxdf = material.GetBxDF(ctx, kLambda);
    constexpr int kSamples = 1000000;
    Rng rng(3);
    const Vector3f wo = frame.ToLocal(Normalize(Vector3f{.4f, .3f, .7f}));
    std::vector<double> counts(SphereBins::kCount + 1);
    double passed = 0;
    for (int k = 0; k < kSamples; ++k) {
        const float uc = rng.Uniform();
        const auto s = bxdf.Sample_f(wo, uc, rng.Uniform2D(), kMode);
        const bool scattered = s && !IsSpecular(s->flags);
        ++counts[size_t(scattered ? SphereBins::IndexOf(frame.FromLocal(s->wi))
                                  : SphereBins::kCount)];
        if (s && !scattered) passed += s->f[0] * std::abs(s->wi.z) / s->pdf / kSamples;
    }
    std::vector<double> expected = SphereBins::Integrate(
        [&](Vector3f wi) { return double(bxdf.PDF(wo, frame.ToLocal(wi), kMode)); }, 1e-6);
    double sum = 0;
    for (const double share : expected)
        sum += share;
    expected.push_back(std::max(0.0, 1 - sum));
    for (double &share : expected)
        share *= kSamples;
    EXPECT_GT(TestCounts(counts, expected).pValue, 0.01);
    // Shadow rays: weights of the gap's samples are at most 1/(1 - p_t).
    EXPECT_NEAR(passed, material.NullTransmission(ctx, wo), 0.004);
}

}  // namespace
}  // namespace pbrt::test
