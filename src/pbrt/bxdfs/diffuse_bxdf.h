#pragma once

#include "pbrt/base/bxdf.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

class DiffusePacket;

/// Lambertian reflection on the side of wo; `reflectance` in [0, 1].
class DiffuseBxDF {
  public:
    static constexpr BxDFTraits kTraits{.hasPacket = true};
    using Packet = DiffusePacket;
    using PacketInput = DiffuseBxDF;

    explicit DiffuseBxDF(SampledSpectrum reflectance) : f0(reflectance * InvPi) {}

    /// f on wo's side.
    SampledSpectrum Value() const { return f0; }
    BxDFFlags Flags() const {
        return f0 ? BxDFFlags::Diffuse | BxDFFlags::Reflection : BxDFFlags::Unset;
    }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const {
        return SameHemisphere(wo, wi) ? f0 : SampledSpectrum(0);
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        return SameHemisphere(wo, wi) ? CosineHemispherePDF(AbsCosTheta(wi)) : 0;
    }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float, Point2f u, TransportMode) const {
        Vector3f wi = SampleCosineHemisphere(u);
        wi.z = std::copysign(wi.z, wo.z);
        if (!SameHemisphere(wo, wi)) return {};
        return BSDFSample{f0, wi, CosineHemispherePDF(AbsCosTheta(wi)),
                          BxDFFlags::Diffuse | BxDFFlags::Reflection};
    }

  private:
    SampledSpectrum f0;
};
static_assert(BxDFType<DiffuseBxDF>);

/// Sixteen of DiffuseBxDF, by its formulas.
class DiffusePacket {
  public:
    void Set(int i, const DiffuseBxDF &bxdf) { f0[size_t(i)] = bxdf.Value(); }
    void Regularize(int) {}
    BxDFFlags Flags(int i) const {
        return f0[size_t(i)] ? BxDFFlags::Diffuse | BxDFFlags::Reflection : BxDFFlags::Unset;
    }
    BxDFValues Evaluate(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active) const {
        BxDFValues values;
        const FloatX16 cosine = wi.z * CopySign(1.f, wo.z);
        ForEachLane(active & BitsOf(cosine > 0.f),
                    [&](int i) { values.f[size_t(i)] = f0[size_t(i)]; });
        values.pdf = Max(cosine, 0.f) * InvPi;
        return values;
    }
    BxDFSamples Sample(const Vector3fX16 &wo, const FloatX16 &, const Point2fX16 &u,
                       LaneBits active) const {
        BxDFSamples samples;
        samples.wi = SampleCosineHemisphere(u);
        samples.pdf = samples.wi.z * InvPi;
        samples.wi.z = CopySign(samples.wi.z, wo.z);
        samples.f = f0;
        samples.valid = active & BitsOf(samples.pdf > 0.f);
        return samples;
    }

  private:
    std::array<SampledSpectrum, kPacketSize> f0;
};
static_assert(BxDFPacketType<DiffusePacket, DiffuseBxDF>);

}  // namespace pbrt
