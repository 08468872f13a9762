// BxDFs side by side against one by one.

#include "pbrt/bxdfs/bxdf_packet.h"

#include <gtest/gtest.h>

#include "feather/model.h"
#include "pbrt/bxdfs/conductor_bxdf.h"
#include "pbrt/bxdfs/diffuse_bxdf.h"
#include "pbrt/bxdfs/feather_barbule_packet.h"
#include "pbrt/bxdfs/hair_bxdf.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

Vector3fX16 AnyDirections(Rng &rng) {
    Vector3fX16 w;
    for (int i = 0; i < kPacketSize; ++i)
        SetLane(&w, i, SampleUniformSphere(rng.Uniform2D()));
    return w;
}

/// Every mask of eight bits twice over, other directions for each. `make` gives a packet's input.
struct Tolerances {
    float f = 1e-5f;  ///< relative
    /// Of sampled directions and, relative, of their densities.
    float wi = 1e-6f, pdf = 1e-5f;
};
template <BxDFType BxDF, typename Make>
void ExpectAlike(const Make &make, const Tolerances &least = {}) {
    Rng rng(1);
    for (LaneBits half = 1; half < 256; ++half) {
        const LaneBits active = half | half << 8;
        std::array<std::optional<BxDF>, kPacketSize> single;
        BxDFPacket<BxDF> lanes;
        ForEachLane(active, [&](int i) {
            single[size_t(i)].emplace(make(i));
            lanes.Set(i, make(i));
        });
        const Vector3fX16 wo = AnyDirections(rng), wi = AnyDirections(rng);
        Point2fX16 u;
        FloatX16 uc;
        for (int i = 0; i < kPacketSize; ++i) {
            SetLane(&u, i, rng.Uniform2D());
            uc.Set(i, rng.Uniform());
        }
        const BxDFValues values = lanes.Evaluate(wo, wi, active);
        const BxDFSamples samples = lanes.Sample(wo, uc, u, active);
        EXPECT_EQ(samples.valid & ~active, 0u);
        ForEachLane(active, [&](int i) {
            const BxDF &bxdf = *single[size_t(i)];
            const Vector3f o = Lane(wo, i), in = Lane(wi, i);
            const auto mode = TransportMode::Radiance;
            EXPECT_EQ(lanes.Flags(i), bxdf.Flags());
            const SampledSpectrum f = bxdf.f(o, in, mode);
            for (int k = 0; k < NSpectrumSamples; ++k)
                EXPECT_NEAR(values.f[size_t(i)][k], f[k], least.f * f[k]);
            const float pdf = bxdf.PDF(o, in, mode);
            EXPECT_NEAR(values.pdf[i], pdf, 1e-5f * pdf);
            const auto s = bxdf.Sample_f(o, uc[i], Lane(u, i), mode);
            ASSERT_EQ(bool(samples.valid >> i & 1), bool(s));
            if (!s) return;
            // The warp is the same formula; contraction may round its steps otherwise.
            EXPECT_LT(Length(Lane(samples.wi, i) - s->wi), least.wi);
            EXPECT_NEAR(samples.pdf[i], s->pdf, least.pdf * (1 + s->pdf));
            EXPECT_EQ(bool(samples.specular >> i & 1), IsSpecular(s->flags));
            EXPECT_EQ(bool(samples.nullTransmission >> i & 1),
                      Has(s->flags, BxDFFlags::NullTransmission));
            EXPECT_EQ(bool(samples.transmission >> i & 1), Has(s->flags, BxDFFlags::Transmission));
        });
    }
}

TEST(BxDFPacket, MattOnesAreAsOneByOne) {
    ExpectAlike<DiffuseBxDF>([](int i) {
        return DiffuseBxDF(SampledSpectrum(std::array{0.1f, 0.5f, 0.9f, float(i) / kPacketSize}));
    });
}

TEST(BxDFPacket, OthersAreAsOneByOne) {
    ExpectAlike<ConductorBxDF>([](int i) {
        const float alpha = 0.1f + 0.05f * float(i);
        return ConductorBxDF(SampledSpectrum(0.2f), SampledSpectrum(3), alpha, alpha);
    });
}

TEST(BxDFPacket, HairsAreAsOneByOne) {
    ExpectAlike<HairBxDF>([](int i) {
        const float h = -0.9f + 0.1f * float(i);
        return HairBxDF(h, 1.55f, SampledSpectrum(std::array{0.1f, 0.5f, 0.9f, 2.f}), 0.3f, 0.2f,
                        2);
    });
}

// TRT's inverses are rough; see Lanes in test/feather. A point of a facet is found by a root, which
// makes 2.4e-4 of a rounding where it vanishes, and a mirror doubles that.
TEST(BxDFPacket, FeathersAreNearlyAsOneByOne) {
    ExpectAlike<FeatherBarbuleBxDF>(
        [](int i) {
            const feather::Shape shape{.thickness = 500 + 20. * i,
                                       .spacing = i % 2 ? 2.5 : 1.25,
                                       .opening = i % 3 ? 0.0785 : 0.4};
            return FeatherSurface{feather::Vane<float>(feather::ParamsOf<float>(shape)),
                                  i % 5 < 3 ? std::optional<float>() : -0.25f - 0.01f * float(i),
                                  float(shape.thickness), i % 4 < 2 ? 0 : 5.f * float(i),
                                  feather::Feather<float>()};
        },
        {.f = 1e-3f, .wi = 5e-4f, .pdf = 1e-3f});
}

}  // namespace
}  // namespace pbrt
