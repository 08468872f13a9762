#pragma once

#include <array>

#include "pbrt/bxdfs/bxdf.h"
#include "pbrt/bxdfs/diffuse.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// f and PDF of sixteen pairs of directions.
struct BxDFValues {
    std::array<SampledSpectrum, kPacketSize> f;
    FloatX16 pdf{};
};

/// Sixteen of BSDFSample; only the `valid` lanes mean something.
struct BxDFSamples {
    std::array<SampledSpectrum, kPacketSize> f;
    Vector3fX16 wi{};
    FloatX16 pdf{};
    FloatX16 eta = 1;
    LaneBits valid = 0, specular = 0, nullTransmission = 0, transmission = 0;
};

/// The BxDFs of sixteen surfaces, one by one.
template <typename BxDF>
class BxDFPacket {
  public:
    void Set(int i, const BxDF &bxdf) { lanes[size_t(i)].emplace(bxdf); }
    void Regularize(int i) { pbrt::Regularize(*lanes[size_t(i)]); }
    BxDFFlags Flags(int i) const { return lanes[size_t(i)]->Flags(); }

    BxDFValues Evaluate(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active) const {
        BxDFValues values;
        ForEachLane(active, [&](int i) {
            const BSDFEval both = Evaluate(*lanes[size_t(i)], Lane(wo, i), Lane(wi, i));
            values.f[size_t(i)] = both.f;
            values.pdf.Set(i, both.pdf);
        });
        return values;
    }

    BxDFSamples Sample(const Vector3fX16 &wo, const FloatX16 &uc, const Point2fX16 &u,
                       LaneBits active) const {
        BxDFSamples samples;
        ForEachLane(active, [&](int i) {
            const auto s =
                lanes[size_t(i)]->Sample_f(Lane(wo, i), uc[i], Lane(u, i), TransportMode::Radiance);
            if (!s) return;
            samples.f[size_t(i)] = s->f;
            SetLane(&samples.wi, i, s->wi);
            samples.pdf.Set(i, s->pdf);
            samples.eta.Set(i, s->eta);
            samples.valid |= LaneBits(1) << i;
            samples.specular |= LaneBits(IsSpecular(s->flags)) << i;
            samples.nullTransmission |= LaneBits(Has(s->flags, BxDFFlags::NullTransmission)) << i;
            samples.transmission |= LaneBits(Has(s->flags, BxDFFlags::Transmission)) << i;
        });
        return samples;
    }

  private:
    static BSDFEval Evaluate(const BxDF &bxdf, Vector3f wo, Vector3f wi) {
        constexpr auto mode = TransportMode::Radiance;
        if constexpr (requires { bxdf.Evaluate(wo, wi, mode); })
            return bxdf.Evaluate(wo, wi, mode);
        else
            return {bxdf.f(wo, wi, mode), bxdf.PDF(wo, wi, mode)};
    }
    std::array<std::optional<BxDF>, kPacketSize> lanes;
};

/// Matt surfaces side by side: DiffuseBxDF's formulas.
template <>
class BxDFPacket<DiffuseBxDF> {
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

}  // namespace pbrt
