#pragma once

#include "pbrt/integrators/path/shade_groups_of.h"
#include "pbrt/util/sampling.h"

namespace pbrt::bench {

/// The feather's f, drawn by a cosine lobe as one would without a model of what is seen: the gap by
/// its fraction of light, else nine in ten about the normal on wo's side, the rest on the other.
class CosineLobe {
  public:
    static constexpr BxDFTraits kTraits{};
    explicit CosineLobe(const FeatherBarbuleBxDF &feather) : feather(feather) {}

    BxDFFlags Flags() const { return feather.Flags(); }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode mode) const {
        return feather.f(wo, wi, mode);
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        return (1 - feather.GapFraction(wo)) * Lobe(wo, wi);
    }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f u, TransportMode mode) const {
        const float gap = feather.GapFraction(wo);
        if (uc < gap)
            return BSDFSample{
                SampledSpectrum(gap / std::abs(wo.z)), -wo, gap,
                BxDFFlags::Transmission | BxDFFlags::Specular | BxDFFlags::NullTransmission};
        const bool sameSide = (uc - gap) / (1 - gap) < kSameSide;
        Vector3f wi = SampleCosineHemisphere(u);
        if ((wo.z < 0) == sameSide) wi.z = -wi.z;
        const float pdf = (1 - gap) * Lobe(wo, wi);
        if (!(pdf > 0)) return {};
        const BxDFFlags side = sameSide ? BxDFFlags::Reflection : BxDFFlags::Transmission;
        return BSDFSample{feather.f(wo, wi, mode), wi, pdf, side | BxDFFlags::Glossy};
    }

  private:
    static constexpr float kSameSide = 0.9f;
    static float Lobe(Vector3f wo, Vector3f wi) {
        return (SameHemisphere(wo, wi) ? kSameSide : 1 - kSameSide) * std::abs(wi.z) * InvPi;
    }
    FeatherBarbuleBxDF feather;
};

/// For ShadeGroupsOf: feathers are drawn by the cosine lobe, all else as it is.
struct FeathersByCosine : DefaultScattering {
    using DefaultScattering::PacketInputAt;
    static CosineLobe PacketInputAt(const FeatherBarbuleMaterial &feather,
                                    const TextureEvalContext &ctx, SampledWavelengths &lambda) {
        return CosineLobe(feather.GetBxDF(ctx, lambda));
    }
    template <MaterialType M>
    using BxDF = std::conditional_t<std::same_as<M, FeatherBarbuleMaterial>, CosineLobe, BxDFOf<M>>;
};

}  // namespace pbrt::bench
