#pragma once

#include "pbrt/base/bxdf.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// Thin and diffuse, like paper: Lambertian on both sides. Energy is kept where `reflectance` and
/// `transmittance`, each >= 0, add to 1 at most.
class DiffuseTransmissionBxDF {
  public:
    static constexpr BxDFTraits kTraits{};

    DiffuseTransmissionBxDF(SampledSpectrum reflectance, SampledSpectrum transmittance)
        : reflected(reflectance * InvPi), transmitted(transmittance * InvPi) {
        const float r = reflected.MaxComponentValue(), t = transmitted.MaxComponentValue();
        if (r + t > 0) chanceOfReflection = r / (r + t);
    }

    BxDFFlags Flags() const {
        BxDFFlags flags = BxDFFlags::Unset;
        if (reflected) flags = flags | BxDFFlags::Diffuse | BxDFFlags::Reflection;
        if (transmitted) flags = flags | BxDFFlags::Diffuse | BxDFFlags::Transmission;
        return flags;
    }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const {
        return SameHemisphere(wo, wi) ? reflected : transmitted;
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        return Chance(SameHemisphere(wo, wi)) * CosineHemispherePDF(AbsCosTheta(wi));
    }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f u, TransportMode) const {
        const bool reflects = uc < chanceOfReflection;
        const SampledSpectrum f = reflects ? reflected : transmitted;
        Vector3f wi = SampleCosineHemisphere(u);
        wi.z = std::copysign(wi.z, reflects ? wo.z : -wo.z);
        if (!f || wi.z == 0) return {};
        return BSDFSample{
            f, wi, Chance(reflects) * CosineHemispherePDF(AbsCosTheta(wi)),
            BxDFFlags::Diffuse | (reflects ? BxDFFlags::Reflection : BxDFFlags::Transmission)};
    }

  private:
    float Chance(bool reflects) const {
        return reflects ? chanceOfReflection : 1 - chanceOfReflection;
    }
    SampledSpectrum reflected, transmitted;
    float chanceOfReflection = 0.5f;
};
static_assert(BxDFType<DiffuseTransmissionBxDF>);

}  // namespace pbrt
