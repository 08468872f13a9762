// BxDFs side by side against one by one.

#include "pbrt/bxdfs/bxdf_lanes.h"

#include <gtest/gtest.h>

#include "pbrt/bxdfs/conductor.h"
#include "pbrt/bxdfs/hair.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

WideVector3f AnyDirections(Rng &rng) {
    WideVector3f w;
    for (int i = 0; i < kWide; ++i)
        SetLane(&w, i, SampleUniformSphere(rng.Uniform2D()));
    return w;
}

/// Every mask of eight bits twice over, other directions for each.
template <typename BxDF, typename Make>
void ExpectAlike(const Make &make) {
    Rng rng(1);
    for (LaneBits half = 1; half < 256; ++half) {
        const LaneBits active = half | half << 8;
        std::array<std::optional<BxDF>, kWide> single;
        BxDFLanes<BxDF> lanes;
        ForEachLane(active, [&](int i) {
            single[size_t(i)].emplace(make(i));
            lanes.Set(i, *single[size_t(i)]);
        });
        const WideVector3f wo = AnyDirections(rng), wi = AnyDirections(rng);
        WidePoint2f u;
        for (int i = 0; i < kWide; ++i)
            SetLane(&u, i, rng.Uniform2D());
        const BxDFValues values = lanes.Evaluate(wo, wi, active);
        const BxDFSamples samples = lanes.Sample(wo, WideFloat{}, u, active);
        EXPECT_EQ(samples.valid & ~active, 0u);
        ForEachLane(active, [&](int i) {
            const BxDF &bxdf = *single[size_t(i)];
            const Vector3f o = Lane(wo, i), in = Lane(wi, i);
            const auto mode = TransportMode::Radiance;
            EXPECT_EQ(lanes.Flags(i), bxdf.Flags());
            const SampledSpectrum f = bxdf.f(o, in, mode);
            for (int k = 0; k < NSpectrumSamples; ++k)
                EXPECT_NEAR(values.f[size_t(i)][k], f[k], 1e-5f * f[k]);
            const float pdf = bxdf.PDF(o, in, mode);
            EXPECT_NEAR(values.pdf[i], pdf, 1e-5f * pdf);
            const auto s = bxdf.Sample_f(o, 0, Lane(u, i), mode);
            ASSERT_EQ(bool(samples.valid >> i & 1), bool(s));
            if (!s) return;
            // The warp is the same formula; contraction may round its steps otherwise.
            EXPECT_LT(Length(Lane(samples.wi, i) - s->wi), 1e-6f);
            EXPECT_NEAR(samples.pdf[i], s->pdf, 1e-5f * (1 + s->pdf));
            EXPECT_EQ(bool(samples.specular >> i & 1), IsSpecular(s->flags));
            EXPECT_FALSE(samples.gap >> i & 1);
            EXPECT_EQ(bool(samples.transmission >> i & 1), Has(s->flags, BxDFFlags::Transmission));
        });
    }
}

TEST(BxDFLanes, MattOnesAreAsOneByOne) {
    ExpectAlike<DiffuseBxDF>([](int i) {
        return DiffuseBxDF(SampledSpectrum(std::array{0.1f, 0.5f, 0.9f, float(i) / kWide}));
    });
}

TEST(BxDFLanes, OthersAreAsOneByOne) {
    ExpectAlike<ConductorBxDF>([](int i) {
        const float alpha = 0.1f + 0.05f * float(i);
        return ConductorBxDF(SampledSpectrum(0.2f), SampledSpectrum(3), alpha, alpha);
    });
}

TEST(BxDFLanes, HairsAreAsOneByOne) {
    ExpectAlike<HairBxDF>([](int i) {
        const float h = -0.9f + 0.1f * float(i);
        return HairBxDF(h, 1.55f, SampledSpectrum(std::array{0.1f, 0.5f, 0.9f, 2.f}), 0.3f, 0.2f,
                        2);
    });
}

}  // namespace
}  // namespace pbrt
