#include "pbrt/util/sampling.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "oracle/inverse_warps.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

using Warp = std::function<Vector3f(Point2f)>;
using Unwarp = std::function<Point2f(Vector3f)>;

struct Pair {
    const char *name;
    Warp warp;
    Unwarp unwarp;
    float tolerance;
};

Vector3f In3D(Point2f p) {
    return {p.x, p.y, 0};
}
Point2f In2D(Vector3f p) {
    return {p.x, p.y};
}

std::vector<Pair> Pairs() {
    std::vector<Pair> pairs{
        {"disk", [](Point2f u) { return In3D(SampleUniformDiskConcentric(u)); },
         [](Vector3f p) { return InvertUniformDiskConcentric(In2D(p)); }, 1e-6f},
        {"cosine", SampleCosineHemisphere<float>, InvertCosineHemisphere, 1e-6f},
        {"triangle", [](Point2f u) { return In3D(SampleUniformTriangle(u)); },
         [](Vector3f p) { return InvertUniformTriangle(In2D(p)); }, 1e-6f},
    };
    for (float d : {2.f, 1.f, 0.1f, 1e-5f}) {
        pairs.push_back({"cone", [d](Point2f u) { return SampleUniformCone(u, d); },
                         [d](Vector3f w) { return InvertUniformCone(w, d); }, 1e-5f});
    }
    return pairs;
}

TEST(Sampling, InverseUndoesTheWarp) {
    Rng rng(1);
    for (const Pair &pair : Pairs()) {
        for (int i = 0; i < 1000; ++i) {
            // Near u.x = 0 the angle about the axis is lost in rounding.
            const Point2f u{0.01f + 0.99f * rng.Uniform(), rng.Uniform()};
            const Point2f back = pair.unwarp(pair.warp(u));
            EXPECT_NEAR(back.x, u.x, pair.tolerance) << pair.name;
            EXPECT_NEAR(back.y, u.y, pair.tolerance) << pair.name;
        }
    }
}

/// Area elements: |dp/du x dp/dv| of each warp is 1 / pdf (central differences in double would
/// need a template; a step of 2^-8 in float gives 1 %).
TEST(Sampling, JacobianIsOneOverDensity) {
    struct Case {
        const char *name;
        Warp warp;
        std::function<float(Vector3f)> pdf;
    };
    const std::vector<Case> cases{
        {"disk", [](Point2f u) { return In3D(SampleUniformDiskConcentric(u)); },
         [](Vector3f) { return InvPi; }},
        {"cosine", SampleCosineHemisphere<float>,
         [](Vector3f w) { return CosineHemispherePDF(w.z); }},
        {"hemisphere", SampleUniformHemisphere, [](Vector3f) { return UniformHemispherePDF; }},
        {"sphere", SampleUniformSphere, [](Vector3f) { return UniformSpherePDF; }},
        {"cone", [](Point2f u) { return SampleUniformCone(u, 0.3f); },
         [](Vector3f) { return UniformConePDF(0.3f); }},
        {"triangle", [](Point2f u) { return In3D(SampleUniformTriangle(u)); },
         [](Vector3f) { return 2.f; }},
    };
    Rng rng(2);
    const float h = 0x1p-8f;
    for (const Case &c : cases) {
        for (int i = 0; i < 200; ++i) {
            const Point2f u{0.1f + 0.8f * rng.Uniform(), 0.1f + 0.8f * rng.Uniform()};
            // The square's diagonals are creases of the disk's and the triangle's maps.
            if (std::abs(u.x - u.y) < 3 * h || std::abs(u.x + u.y - 1) < 3 * h) continue;
            const Vector3f du = (c.warp({u.x + h, u.y}) - c.warp({u.x - h, u.y})) / (2 * h);
            const Vector3f dv = (c.warp({u.x, u.y + h}) - c.warp({u.x, u.y - h})) / (2 * h);
            EXPECT_NEAR(Length(Cross(du, dv)) * c.pdf(c.warp(u)), 1, 0.01) << c.name;
        }
    }
}

TEST(Sampling, WarpsStayInTheirDomainAtTheCorners) {
    for (float x : {0.f, 0.5f, OneMinusEpsilon}) {
        for (float y : {0.f, 0.5f, OneMinusEpsilon}) {
            const Point2f u{x, y}, d = SampleUniformDiskConcentric(u);
            EXPECT_LE(d.x * d.x + d.y * d.y, 1 + 1e-6f);
            EXPECT_NEAR(Length(SampleCosineHemisphere(u)), 1, 1e-6f);
            EXPECT_GE(SampleCosineHemisphere(u).z, 0);
            EXPECT_NEAR(Length(SampleUniformSphere(u)), 1, 1e-6f);
            EXPECT_NEAR(Length(SampleUniformCone(u, 1e-7f)), 1, 1e-6f);
            const Point2f b = SampleUniformTriangle(u);
            EXPECT_TRUE(b.x >= 0 && b.y >= 0 && b.x + b.y <= 1);
        }
    }
}

TEST(Sampling, TentMatchesItsDensityAndInverse) {
    const float r = 1.7f;
    for (int i = 1; i < 1000; ++i) {
        const float u = float(i) / 1000, h = 1e-3f, x = SampleTent(u, r);
        EXPECT_NEAR(InvertTent(x, r), u, 1e-6);
        if (i > 10 && i < 990 && std::abs(i - 500) > 2) {
            const float slope = (SampleTent(u + h, r) - SampleTent(u - h, r)) / (2 * h);
            EXPECT_NEAR(slope * TentPDF(x, r), 1, 5e-3);
        }
    }
}

}  // namespace
}  // namespace pbrt
