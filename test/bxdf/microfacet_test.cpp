#include "pbrt/bxdfs/microfacet.h"

#include <gtest/gtest.h>

#include "support/quadrature.h"

namespace pbrt {
namespace {

struct Widths {
    float x, y;
};
constexpr Widths kWidths[]{{0.1f, 0.1f}, {0.4f, 0.15f}, {0.7f, 0.7f}, {2, 0.5f}};

Vector3f Direction(double cosTheta, double phi) {
    const double s = std::sqrt(1 - cosTheta * cosTheta);
    return {float(s * std::cos(phi)), float(s * std::sin(phi)), float(cosTheta)};
}

/// By angles, among which lobes are wider than among cosines.
template <typename F>
double OverHemisphere(const F &f) {
    const auto byAngles = [&](double phi, double theta) {
        return std::sin(theta) * f(Direction(std::cos(theta), phi));
    };
    return test::IntegrateAdaptively(byAngles, {0, 2 * M_PI, 0, M_PI / 2}, 1e-5);
}

/// The projected area of all facets is that of the surface.
TEST(TrowbridgeReitz, DensityIsNormalised) {
    for (auto [x, y] : kWidths) {
        const TrowbridgeReitz facets(x, y);
        const auto f = [&](Vector3f m) { return double(facets.D(m)) * m.z; };
        EXPECT_NEAR(OverHemisphere(f), 1, 1e-3) << x << " " << y;
    }
}

/// The projected area of the visible facets is that of the surface from every side, so G1 is
/// right; then the visible normals' density is normalised too.
TEST(TrowbridgeReitz, VisibleFacetsCoverTheSurface) {
    for (auto [x, y] : kWidths) {
        const TrowbridgeReitz facets(x, y);
        for (const Vector3f &w : {Direction(0.9, 1), Direction(0.3, 2), Direction(0.05, 4)}) {
            const auto f = [&](Vector3f m) {
                return double(facets.D(m)) * facets.G1OverCosine(w) * std::max(0.f, Dot(w, m));
            };
            EXPECT_NEAR(OverHemisphere(f), 1, 2e-3) << x << " " << y << " " << w.z;
        }
    }
}

/// In terms of Lambda, from which the forms in the class are derived.
TEST(TrowbridgeReitz, MaskingIsSmiths) {
    for (auto [ax, ay] : kWidths) {
        const TrowbridgeReitz facets(ax, ay);
        const auto lambda = [ax = ax, ay = ay](Vector3f w) {
            const double tan2 = (Sqr(double(ax) * w.x) + Sqr(double(ay) * w.y)) / Sqr(double(w.z));
            return (std::sqrt(1 + tan2) - 1) / 2;
        };
        const Vector3f wo = Direction(0.4, 1), wi = Direction(-0.7, 3);
        const double cosines = 0.4 * 0.7;
        EXPECT_NEAR(facets.GOverCosines(wo, wi) * cosines, 1 / (1 + lambda(wo) + lambda(wi)), 1e-5);
        EXPECT_NEAR(facets.G1OverCosine(wo) * 0.4, 1 / (1 + lambda(wo)), 1e-5);
    }
}

TEST(TrowbridgeReitz, DensityDoesNotDependOnTheNormalsLength) {
    const TrowbridgeReitz facets(0.2f, 0.5f);
    const Vector3f m = Normalize(Vector3f{0.1f, -0.4f, 0.8f});
    EXPECT_NEAR(facets.D(1e-6f * m) / facets.D(m), 1, 1e-5);
    EXPECT_NEAR(facets.D(-7.f * m) / facets.D(m), 1, 1e-5);
}

TEST(TrowbridgeReitz, RegularizeWidensOnlyWhatIsSharp) {
    const auto peak = [](TrowbridgeReitz facets) {
        facets.Regularize();
        return facets.D({0, 0, 1}) * Pi;  // 1 / (ax ay)
    };
    EXPECT_FLOAT_EQ(peak({0, 0}), 1 / Sqr(0.1f));
    EXPECT_FLOAT_EQ(peak({0.08f, 0.5f}), 1 / (0.16f * 0.5f));
    EXPECT_FLOAT_EQ(peak({0.2f, 0.3f}), 1 / Sqr(0.3f));
}

TEST(TrowbridgeReitz, SmoothBelowAThousandth) {
    EXPECT_TRUE(TrowbridgeReitz(0, 0.0009f).IsSmooth());
    EXPECT_FALSE(TrowbridgeReitz(0, 0.0011f).IsSmooth());
}

}  // namespace
}  // namespace pbrt
