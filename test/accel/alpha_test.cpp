// Cut-outs by alpha and light through surfaces with gaps.

#include "accel/trace.h"

namespace pbrt {
namespace {

TriangleMesh Square(float z, float half = 1) {
    TriangleMesh mesh;
    mesh.p = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// alpha(u, v) = u.
struct AlongU final : FloatNode {
    float Evaluate(const TextureEvalContext &ctx) const override { return ctx.uv.x; }
};

Ray Down(float x, float y) {
    return {{x, y, 10}, {0, 0, -1}};
}

TEST(Alpha, ConstantIsTheShareOfHits) {
    for (const float alpha : {0.1f, 0.5f, 0.9f}) {
        std::vector<Geometry> geometries(3);
        geometries[0].shape = Square(0);
        geometries[1].shape = Sphere{Transform::Translate({5, 0, 0})};
        BilinearMesh patch;
        patch.p = {{9, -1, 0}, {11, -1, 0.5f}, {9, 1, 0}, {11, 1, 0}};
        patch.indices = {0, 1, 2, 3};
        geometries[2].shape = patch;
        for (Geometry &g : geometries)
            g.alpha = alpha;
        const Accel accel(geometries, 3, {}, {}, 1);
        Rng rng(1);
        const int n = 40000;
        for (const float x : {0.f, 5.f, 10.f}) {
            int hits = 0;
            for (int i = 0; i < n; ++i) {
                const Ray ray = Down(x + rng.Uniform() - 0.5f, rng.Uniform() - 0.5f);
                Hit hit;
                const bool found = accel.Intersect(ray, &hit);
                EXPECT_EQ(accel.Occluded(ray), found);
                hits += found;
            }
            // A sphere's two walls are cut independently. 5 sigma.
            const float share = x == 5 ? 1 - Sqr(1 - alpha) : alpha;
            EXPECT_NEAR(float(hits) / n, share, 5 * std::sqrt(share * (1 - share) / n)) << x;
        }
    }
}

TEST(Alpha, TextureIsLookedUpAtTheHit) {
    std::vector<Geometry> geometries(1);
    geometries[0].shape = Square(0);
    geometries[0].alpha = FloatTexture(std::make_shared<AlongU>());
    const Accel accel(geometries, 1, {}, {}, 1);
    Rng rng(1);
    int hits[8] = {};
    const int n = 5000;
    for (int k = 0; k < 8; ++k)
        for (int i = 0; i < n; ++i)
            hits[k] +=
                accel.Occluded(Down((k + rng.Uniform()) / 4 - 1, 1.9f * rng.Uniform() - 0.95f));
    for (int k = 0; k < 8; ++k) {
        const float share = (k + 0.5f) / 8;  // 5 sigma, at most that of a half
        EXPECT_NEAR(float(hits[k]) / n, share, 5 * 0.5f / std::sqrt(float(n)));
    }
}

TEST(Alpha, CutOutsLeaveTheNextSurface) {
    std::vector<Geometry> geometries(2);
    geometries[0].shape = Square(1);
    geometries[0].alpha = 0.5f;
    geometries[1].shape = Square(0);
    const Accel accel(geometries, 2, {}, {}, 1);
    Rng rng(1);
    int first = 0;
    for (int i = 0; i < 1000; ++i) {
        Hit hit;
        ASSERT_TRUE(accel.Intersect(Down(rng.Uniform(), rng.Uniform()), &hit));
        first += hit.geometry == 0;
    }
    EXPECT_NEAR(first, 500, 5 * 16);
}

TEST(Alpha, ZeroIsInvisibleButLights) {
    std::vector<Geometry> geometries(1);
    geometries[0].shape = Square(0);
    geometries[0].alpha = 0.f;
    geometries[0].hasNullTransmission = true;
    const Accel accel(geometries, 1, {}, {}, 1);
    EXPECT_FALSE(accel.Occluded(Down(0.1f, 0.2f)));
    EXPECT_FALSE(accel.HasNullTransmission());
    EXPECT_TRUE(SampleFrom(geometries[0].shape, 0, {0, 0, 2}, {0.3f, 0.4f}));
}

/// Passes 1 - (index + 1) / 1000.
struct Thinning final : NullTransmission {
    static float Of(uint32_t geometry) { return 1 - float(geometry + 1) / 1000; }
    float operator()(const Hit &hit, const Ray &ray) const override {
        EXPECT_NEAR(ray(hit.t).z, float(hit.geometry) * 0.01f, 1e-4f);
        return Of(hit.geometry);
    }
};

TEST(Gaps, TransmittanceIsTheProductOverAnyNumberOfLayers) {
    for (const int layers : {0, 1, 2, 3, 10, 50, 200}) {
        std::vector<Geometry> geometries(size_t(layers) + 1);
        double product = 1;
        for (int i = 0; i < layers; ++i) {
            geometries[size_t(i)].shape = Square(float(i) * 0.01f);
            geometries[size_t(i)].hasNullTransmission = true;
            product *= Thinning::Of(uint32_t(i));
        }
        geometries[size_t(layers)].shape = Sphere{Transform::Translate({0, 0, -50})};
        const Accel accel(geometries, uint32_t(geometries.size()), {}, {}, 2);
        EXPECT_EQ(accel.HasNullTransmission(), layers > 0);
        Rng rng(9);
        for (int i = 0; i < 200; ++i) {
            // Away from the diagonal, where either triangle may be met.
            const float x = 0.9f * rng.Uniform(), y = -0.9f * rng.Uniform() - 0.01f;
            Ray ray = Down(x, y);
            ray.tMax = 20;
            EXPECT_FLOAT_EQ(accel.Transmittance(ray, Thinning()), float(product));
            EXPECT_EQ(accel.Occluded(ray), layers > 0) << "opaque without a callback";
            ray = Down(0, -0.01f);
            EXPECT_EQ(accel.Transmittance(ray, Thinning()), 0) << "the sphere is opaque";
        }
    }
}

TEST(Gaps, NothingPassesWhereALayerPassesNothing) {
    struct Half final : NullTransmission {
        float operator()(const Hit &hit, const Ray &) const override {
            return hit.geometry == 1 ? 0.f : 0.5f;
        }
    };
    std::vector<Geometry> geometries(3);
    for (int i = 0; i < 3; ++i) {
        geometries[size_t(i)].shape = Square(float(i));
        geometries[size_t(i)].hasNullTransmission = true;
    }
    const Accel accel(geometries, 3, {}, {}, 1);
    EXPECT_EQ(accel.Transmittance(Down(0.5f, 0.2f), Half()), 0);
    Ray upper = Down(0.5f, 0.2f);
    upper.tMax = 8.5f;
    EXPECT_EQ(accel.Transmittance(upper, Half()), 0.5f);
}

TEST(Gaps, ASpherePassesThroughBothWalls) {
    struct Half final : NullTransmission {
        float operator()(const Hit &, const Ray &) const override { return 0.5f; }
    };
    std::vector<Geometry> geometries(1);
    geometries[0].shape = Sphere{};
    geometries[0].hasNullTransmission = true;
    const Accel accel(geometries, 1, {}, {}, 1);
    EXPECT_EQ(accel.Transmittance(Down(0.1f, 0.2f), Half()), 0.25f);
    EXPECT_EQ(accel.Transmittance({{0, 0, 0}, {0, 0, 1}}, Half()), 0.5f);
}

TEST(Gaps, AlphaComesBeforeGaps) {
    struct Half final : NullTransmission {
        float operator()(const Hit &, const Ray &) const override { return 0.5f; }
    };
    std::vector<Geometry> geometries(1);
    geometries[0].shape = Square(0);
    geometries[0].hasNullTransmission = true;
    geometries[0].alpha = 0.4f;
    const Accel accel(geometries, 1, {}, {}, 1);
    Rng rng(2);
    double sum = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i)
        sum += accel.Transmittance(Down(rng.Uniform(), rng.Uniform()), Half());
    EXPECT_NEAR(sum / n, 0.4 * 0.5 + 0.6, 5 * 0.25 / std::sqrt(double(n)));
}

}  // namespace
}  // namespace pbrt
