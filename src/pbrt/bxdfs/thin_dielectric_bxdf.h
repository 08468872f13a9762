#pragma once

#include <algorithm>

#include "pbrt/base/bxdf.h"
#include "pbrt/bxdfs/fresnel.h"

namespace pbrt {

/// A pane of glass thinner than what the scene shows of it: light is mirrored or goes straight on.
/// Both faces reflect in turn without interference, R' = R + T^2 R / (1 - R^2) = 2 R / (1 + R).
class ThinDielectricBxDF {
  public:
    static constexpr BxDFTraits kTraits{};

    /// eta > 0: index of the glass over that around it.
    explicit ThinDielectricBxDF(float eta) : eta(eta) {}

    BxDFFlags Flags() const {
        return BxDFFlags::Reflection | BxDFFlags::Transmission | BxDFFlags::Specular;
    }
    SampledSpectrum f(Vector3f, Vector3f, TransportMode) const { return SampledSpectrum(0); }
    float PDF(Vector3f, Vector3f, TransportMode) const { return 0; }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f, TransportMode) const {
        const float cosTheta = AbsCosTheta(wo);
        if (cosTheta < kMinDeltaCosine) return {};
        const float face = FrDielectric(std::min(1.f, cosTheta), eta).R;
        const float R = 2 * face / (1 + face), T = 1 - R;
        if (uc < R)
            return BSDFSample{SampledSpectrum(R / cosTheta),
                              {-wo.x, -wo.y, wo.z},
                              R,
                              BxDFFlags::Reflection | BxDFFlags::Specular};
        if (T == 0) return {};
        return BSDFSample{SampledSpectrum(T / cosTheta), -wo, T,
                          BxDFFlags::Transmission | BxDFFlags::Specular};
    }

  private:
    float eta;
};
static_assert(BxDFType<ThinDielectricBxDF>);

}  // namespace pbrt
