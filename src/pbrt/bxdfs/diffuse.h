#pragma once

#include "pbrt/bxdfs/bxdf.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// Lambertian reflection on the side of wo; `reflectance` in [0, 1].
class DiffuseBxDF {
  public:
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
static_assert(BxDFModel<DiffuseBxDF>);

}  // namespace pbrt
