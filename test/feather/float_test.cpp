// What renders in float against the same code in double.

#include <gtest/gtest.h>

#include "feather/model.h"

namespace pbrt::feather {
namespace {

struct Differences {
    std::vector<double> relative;
    double At(double quantile) {
        std::sort(relative.begin(), relative.end());
        return relative[std::size_t(quantile * (relative.size() - 1))];
    }
};

// A facet near the edge of what is seen may be seen in one scalar and not in the other: those are
// counted, not compared.
TEST(Float, GlintIsWithinOneInAHundredThousand) {
    Dice dice(50);
    Differences off;
    int edges = 0, lit = 0;
    while (lit < 20000) {
        const Shape shape = lit % 2 ? Shape{} : dice.AnyShape();
        const auto b32 = BarbuleOf<float>(shape);
        const auto b64 = BarbuleOf<double>(shape);
        // A mirrored pair, so that most have a glint.
        const auto wo = Rounded<float>(dice.OnUpperHemisphere());
        const auto s = b32.SampleDirection(b32.SeenFrom(wo), 0.9999f, float(dice.Uniform()),
                                           float(dice.Uniform()));
        if (!s || s->isGap || std::abs(wo.z) < 1e-3 || std::abs(s->wi.z) < 1e-3) continue;
        const auto wide = [](Direction<float> w) { return Direction<double>{w.x, w.y, w.z}; };
        const auto f32 = b32.R(b32.SeenFrom(wo), s->wi);
        const auto f64 = b64.R(b64.SeenFrom(wide(wo)), wide(s->wi));
        if (f32[0] == 0 && f64[0] == 0) continue;  // the light's way is hidden
        ++lit;
        if ((f32[0] > 0) != (f64[0] > 0)) {
            ++edges;
            continue;
        }
        // Relative to the wavelengths' mean: a fringe's minimum may be 0.
        const double mean = (f64[0] + f64[1] + f64[2] + f64[3]) / 4;
        for (int i = 0; i < 4; ++i)
            off.relative.push_back(std::abs(f32[i] - f64[i]) / mean);
    }
    EXPECT_LT(edges, lit / 200);
    EXPECT_LT(off.At(0.5), 1e-6);
    EXPECT_LT(off.At(0.99), 2e-5);
}

TEST(Float, PigmentIsWithinOneInAHundredThousand) {
    Dice dice(51);
    double off = 0, mean = 0;
    const auto b32 = BarbuleOf<float>({});
    const auto b64 = BarbuleOf<double>({});
    const int n = 20000;
    for (int k = 0; k < n; ++k) {
        const Direction<double> wo = dice.OnUpperHemisphere(), wi = dice.OnUpperHemisphere();
        const auto f32 = b32.TRT(b32.SeenFrom(Rounded<float>(wo)), Rounded<float>(wi));
        const auto f64 = b64.TRT(b64.SeenFrom(wo), wi);
        for (int i = 0; i < 4; ++i) {
            off += std::pow((f32[i] - f64[i]) * wo.z * wi.z, 2) / (4 * n);
            mean += f64[i] * wo.z * wi.z / (4 * n);
        }
    }
    EXPECT_LT(std::sqrt(off) / mean, 1e-5);
}

TEST(Float, GapFraction) {
    Dice dice(52);
    Differences off;
    for (int k = 0; k < 50000; ++k) {
        const Shape shape = dice.AnyShape();
        const auto wo = dice.OnSphere();
        if (std::abs(wo.z) < 1e-3) continue;
        off.relative.push_back(std::abs(BarbuleOf<float>(shape).GapFraction(Rounded<float>(wo)) -
                                        BarbuleOf<double>(shape).GapFraction(wo)));
    }
    EXPECT_LT(off.At(0.99), 1e-5);
    EXPECT_LT(off.At(1), 1e-3);
}

}  // namespace
}  // namespace pbrt::feather
