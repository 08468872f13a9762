#pragma once

#include <array>

#include "pbrt/bxdfs/bxdf.h"
#include "pbrt/bxdfs/diffuse.h"
#include "pbrt/util/wide.h"

namespace pbrt {

/// f and PDF of sixteen pairs of directions.
struct BxDFValues {
    std::array<SampledSpectrum, kWide> f;
    WideFloat pdf{};
};

/// Sixteen of BSDFSample; only the `valid` lanes mean something.
struct BxDFSamples {
    std::array<SampledSpectrum, kWide> f;
    WideVector3f wi{};
    WideFloat pdf{};
    WideFloat eta = Broadcast16(1.f);
    LaneBits valid = 0, specular = 0, gap = 0, transmission = 0;
};

/// The BxDFs of sixteen surfaces, one by one.
template <typename BxDF>
class BxDFLanes {
  public:
    void Set(int i, const BxDF &bxdf) { lanes[size_t(i)].emplace(bxdf); }
    void Regularize(int i) { pbrt::Regularize(*lanes[size_t(i)]); }
    BxDFFlags Flags(int i) const { return lanes[size_t(i)]->Flags(); }

    BxDFValues Evaluate(const WideVector3f &wo, const WideVector3f &wi, LaneBits active) const {
        BxDFValues values;
        ForEachLane(active, [&](int i) {
            const FAndPDF both = Both(*lanes[size_t(i)], Lane(wo, i), Lane(wi, i));
            values.f[size_t(i)] = both.f;
            values.pdf[i] = both.pdf;
        });
        return values;
    }

    BxDFSamples Sample(const WideVector3f &wo, const WideFloat &uc, const WidePoint2f &u,
                       LaneBits active) const {
        BxDFSamples samples;
        ForEachLane(active, [&](int i) {
            const auto s =
                lanes[size_t(i)]->Sample_f(Lane(wo, i), uc[i], Lane(u, i), TransportMode::Radiance);
            if (!s) return;
            samples.f[size_t(i)] = s->f;
            SetLane(&samples.wi, i, s->wi);
            samples.pdf[i] = s->pdf;
            samples.eta[i] = s->eta;
            samples.valid |= LaneBits(1) << i;
            samples.specular |= LaneBits(IsSpecular(s->flags)) << i;
            samples.gap |= LaneBits(Has(s->flags, BxDFFlags::Gap)) << i;
            samples.transmission |= LaneBits(Has(s->flags, BxDFFlags::Transmission)) << i;
        });
        return samples;
    }

  private:
    static FAndPDF Both(const BxDF &bxdf, Vector3f wo, Vector3f wi) {
        constexpr auto mode = TransportMode::Radiance;
        if constexpr (requires { bxdf.Both(wo, wi, mode); })
            return bxdf.Both(wo, wi, mode);
        else
            return {bxdf.f(wo, wi, mode), bxdf.PDF(wo, wi, mode)};
    }
    std::array<std::optional<BxDF>, kWide> lanes;
};

/// Matt surfaces side by side: DiffuseBxDF's formulas.
template <>
class BxDFLanes<DiffuseBxDF> {
  public:
    void Set(int i, const DiffuseBxDF &bxdf) { f0[size_t(i)] = bxdf.Value(); }
    void Regularize(int) {}
    BxDFFlags Flags(int i) const {
        return f0[size_t(i)] ? BxDFFlags::Diffuse | BxDFFlags::Reflection : BxDFFlags::Unset;
    }
    BxDFValues Evaluate(const WideVector3f &wo, const WideVector3f &wi, LaneBits active) const {
        BxDFValues values;
        const WideFloat cosine = wi.z * CopySign(1.f, wo.z);
        ForEachLane(active & BitsOf(cosine > 0.f),
                    [&](int i) { values.f[size_t(i)] = f0[size_t(i)]; });
        values.pdf = Max(cosine, 0.f) * InvPi;
        return values;
    }
    BxDFSamples Sample(const WideVector3f &wo, const WideFloat &, const WidePoint2f &u,
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
    std::array<SampledSpectrum, kWide> f0;
};

}  // namespace pbrt
