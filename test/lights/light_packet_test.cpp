// Light for sixteen receivers is what each gets alone.

#include "pbrt/lights/light_packet.h"

#include "lights/light_cases.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt::test {
namespace {

/// A rectangle of one flat patch.
Shape Patch(Point3f corner, Vector3f e1, Vector3f e2) {
    BilinearMesh mesh;
    mesh.indices = {0, 1, 2, 3};
    mesh.p = {corner, corner + e1, corner + e2, corner + e1 + e2};
    mesh.planar = true;
    return mesh;
}
Image Sky(Rng &rng, int n) {
    Image image({n, n}, {"R", "G", "B"});
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            for (int c = 0; c < 3; ++c)
                image.Set({x, y}, c, rng.Below(3) == 0 ? 0 : rng.Uniform());
    return image;
}

class Lights {
  public:
    Lights() {
        const std::string flat = "\"diffuse\" \"spectrum L\" " + kFlat;
        Add(flat, Patch({-1, -1, 3}, {2, 0, 0}, {0, 2, 0}));
        Add(flat + " \"bool twosided\" true \"float scale\" 3",
            Patch({-5, -3, 1}, {0.1f, 0, 0}, {0, 0.1f, 0.02f}));
        Add(flat, Patch({0, 0, -4}, {0, 20, 0}, {0.05f, 0, 0}));
        Add(flat, Patch({1, 1, 1}, {0, 0, 1}, {0, 1, 0}), 0);     // invisible
        Add(flat, Patch({1, 1, 1}, {0, 0, 1}, {0, 1, 0}), 0.3f);  // lets some through
        Add(flat + " \"float scale\" 0", Patch({1, 1, 1}, {0, 0, 1}, {0, 1, 0}));
        Add(flat, Sphere{Transform::Translate({2, 0, 4})});
        const LightScene points(
            "LightSource \"point\" \"point3 from\" [1 2 3]\n"
            "LightSource \"distant\"\nLightSource \"infinite\"");
        lights.insert(lights.end(), points.lights.begin(), points.lights.end());
        for (LightCase &c : AllCases()) {
            lights.push_back(c.light);
            cases.push_back(std::move(c));
        }
        Rng rng(1);
        for (int n : {3, 40}) {
            auto light = ImageInfiniteLight::FromImage(
                Sky(rng, n), RGBColorSpace::sRGB(), 1,
                *Transform::Scale({1, 2, 0.5f}) * *Transform::Rotate(50, {1, 2, -1}));
            light.Preprocess(10);
            lights.push_back(light);
        }
    }
    size_t Size() const { return lights.size(); }
    const Light &operator[](size_t i) const { return lights[i]; }

  private:
    void Add(const std::string &params, Shape shape, float alpha = 1) {
        scenes.push_back(std::make_unique<AreaScene>(params, std::move(shape), alpha));
        EXPECT_EQ(scenes.back()->Messages(), "");
        lights.insert(lights.end(), scenes.back()->lights.begin(), scenes.back()->lights.end());
    }
    std::vector<std::unique_ptr<AreaScene>> scenes;
    std::vector<LightCase> cases;
    std::vector<Light> lights;
};

/// Of the light's surface where the sample lies; 1 where it has none or no flat one.
float CosineAt(const Light &light, Vector3f wi) {
    const auto *area = std::get_if<DiffuseAreaLight>(&light);
    return area && area->surface->rectangle ? AbsDot(area->surface->rectangle->Normal(), wi) : 1;
}

/// Solid angles above 0.01 have absolute errors of 2e-7, which is 2e-5 of the density. A drawn
/// point's x is h c / sqrt(1 - c^2): errors of c move the direction by as much over the squared
/// cosine at the light. They are those of the angles, 4e-7, which c = sin G / sqrt(...) enlarges
/// where the rectangle is seen from its side; 4e-6 allows ten times. Lights are at most 20 away.
void ExpectSame(const LightLiSamples &all, int i, const Light &light, const LightLiSample &one) {
    const float moved = 2e-5f + 4e-6f / Sqr(CosineAt(light, one.wi));
    EXPECT_LT(Length(Lane(all.wi, i) - one.wi), moved);
    EXPECT_LT(Length(Lane(all.pLight, i) - one.pLight), 20 * moved);
    EXPECT_NEAR(all.pdf[i], one.pdf, 2e-4f * one.pdf);
    EXPECT_EQ(all.delta >> i & 1, LaneBits(one.delta));
    for (int k = 0; k < NSpectrumSamples; ++k)
        EXPECT_NEAR(all.L[size_t(i)][k], one.L[k], 1e-6f * one.L[k]);
}

TEST(LightPacket, EachLaneAsAlone) {
    const Lights lights;
    Rng rng(2);
    int lit = 0;
    for (int round = 0; round < 4000; ++round) {
        LightPacket which{};
        WavelengthPacket lambda{};
        std::vector<SampledWavelengths> wavelengths;
        LightSampleContextX16 ctx{};
        Point2fX16 u{};
        const size_t first = rng.Below(uint32_t(lights.Size()));
        const uint32_t count = round % 2 ? 1 : 1 + rng.Below(uint32_t(lights.Size() - first));
        for (int i = 0; i < kPacketSize; ++i) {
            const Point2f a = rng.Uniform2D(), b = rng.Uniform2D();
            SetLane(&ctx.p, i, {8 * a.x - 4, 8 * a.y - 4, 8 * b.x - 4});
            SetLane(&u, i, rng.Uniform2D());
            wavelengths.push_back(SampledWavelengths::SampleVisible(b.y));
        }
        const LaneBits active = round % 4 < 2 ? kAllLanes : rng.Next32() & kAllLanes;
        ForEachLane(active, [&](int i) {
            if (rng.Below(20) != 0) which[size_t(i)] = &lights[first + rng.Below(count)];
            lambda[size_t(i)] = &wavelengths[size_t(i)];
        });
        LightLiSamples samples;
        SampleLi(which, ctx, u, lambda, active, &samples);
        EXPECT_EQ(samples.valid & ~active, 0u);
        ForEachLane(active, [&](int i) {
            std::optional<LightLiSample> one;
            if (which[size_t(i)])
                one = SampleLi(*which[size_t(i)], ctx.At(i), Lane(u, i), *lambda[size_t(i)]);
            ASSERT_EQ(samples.valid >> i & 1, LaneBits(one.has_value()));
            if (one) ExpectSame(samples, i, *which[size_t(i)], *one);
            lit += one.has_value();
        });
    }
    EXPECT_GT(lit, 10000);
}

TEST(LightPacket, SixteenRaysLeaveAsEachAlone) {
    const Lights lights;
    Rng rng(4);
    int same = 0, all = 0;
    for (size_t k = 0; k < lights.Size(); ++k) {
        if (!Traits(lights[k]).isInfinite) continue;
        for (int round = 0; round < 200; ++round) {
            Point3fX16 o;
            Vector3fX16 d;
            WavelengthPacket lambda;
            std::vector<SampledWavelengths> wavelengths;
            for (int i = 0; i < kPacketSize; ++i) {
                SetLane(&o, i, 5 * rng.Uniform() * SampleUniformSphere(rng.Uniform2D()));
                SetLane(&d, i, (0.1f + rng.Uniform()) * SampleUniformSphere(rng.Uniform2D()));
                wavelengths.push_back(SampledWavelengths::SampleVisible(rng.Uniform()));
            }
            for (size_t i = 0; i < kPacketSize; ++i)
                lambda[i] = &wavelengths[i];
            const LaneBits active = round % 2 ? kAllLanes : rng.Next32() & kAllLanes;
            LightLePacket le;
            Le(lights[k], o, d, lambda, active, &le);
            ForEachLane(active, [&](int i) {
                const SampledSpectrum L =
                    Le(lights[k], Ray{Lane(o, i), Lane(d, i)}, wavelengths[size_t(i)]);
                const float pdf = PDF_Li(lights[k], Lane(o, i), Lane(d, i));
                ++all;
                bool equal = std::abs(le.pdf[i] - pdf) <= 1e-5f * pdf;
                for (int s = 0; s < NSpectrumSamples; ++s)
                    equal &= std::abs(le.L[size_t(i)][s] - L[s]) <= 1e-5f * L[s];
                same += equal;
            });
        }
    }
    // On a texel's border rounding decides.
    EXPECT_GE(same, 0.999 * all);
}

TEST(LightPacket, DensitiesOfSkies) {
    const Lights lights;
    Rng rng(3);
    for (size_t k = lights.Size() - 2; k < lights.Size(); ++k) {
        const auto &sky = *std::get_if<ImageInfiniteLight>(&lights[k]);
        for (int round = 0; round < 500; ++round) {
            Vector3fX16 w;
            for (int i = 0; i < kPacketSize; ++i)
                SetLane(&w, i, SampleUniformSphere(rng.Uniform2D()));
            const FloatX16 pdf = sky.PDF_Li(w);
            // On a texel's border rounding decides; these directions keep off.
            for (int i = 0; i < kPacketSize; ++i)
                EXPECT_NEAR(pdf[i], sky.PDF_Li(Lane(w, i)), 1e-5f * pdf[i]);
        }
    }
}

}  // namespace
}  // namespace pbrt::test
