#pragma once

#include "pbrt/base/bxdf.h"
#include "pbrt/bxdfs/fresnel.h"
#include "pbrt/bxdfs/microfacet.h"

namespace pbrt {

/// Metal of complex index eta + i k, relative to the outside: a mirror, or microfacets that are
/// (Torrance and Sparrow 1967; sampling by visible normals). Both sides reflect alike.
class ConductorBxDF {
  public:
    static constexpr BxDFTraits kTraits{.regularizes = true};

    ConductorBxDF(SampledSpectrum eta, SampledSpectrum k, float alphaX, float alphaY)
        : eta(eta), k(k), facets(alphaX, alphaY) {}

    BxDFFlags Flags() const { return BxDFFlags::Reflection | Sharpness(); }

    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const {
        const Vector3f h = wo + wi;
        const float h2 = LengthSquared(h);
        if (!SameHemisphere(wo, wi) || !(h2 > kMinHalf2) || facets.IsSmooth())
            return SampledSpectrum(0);
        // wo . h / |h| = |h| / 2.
        return Fr(0.5f * std::sqrt(h2)) * (0.25f * facets.D(h) * facets.GOverCosines(wo, wi));
    }

    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        const Vector3f h = wo + wi;
        if (!SameHemisphere(wo, wi) || !(LengthSquared(h) > kMinHalf2) || facets.IsSmooth())
            return 0;
        // D G1 |wo . m| / |wo.z| of the normal, and dm / dwi = 1 / (4 |wo . m|).
        return 0.25f * facets.D(h) * facets.G1OverCosine(wo);
    }

    std::optional<BSDFSample> Sample_f(Vector3f wo, float, Point2f u, TransportMode) const {
        if (facets.IsSmooth()) {
            const float cosTheta = AbsCosTheta(wo);
            if (cosTheta < kMinDeltaCosine) return {};
            return BSDFSample{Fr(cosTheta) / cosTheta, {-wo.x, -wo.y, wo.z}, 1, Flags()};
        }
        const Vector3f m = facets.SampleVisibleNormal(wo, u), wi = Reflect(wo, m);
        if (!SameHemisphere(wo, wi)) return {};
        const float D = 0.25f * facets.D(m);
        return BSDFSample{Fr(std::min(1.f, Dot(wo, m))) * (D * facets.GOverCosines(wo, wi)), wi,
                          D * facets.G1OverCosine(wo), Flags()};
    }

    void Regularize() { facets.Regularize(); }

  private:
    /// Both directions graze from opposite sides to within 1e-10: the half vector is rounding
    /// error.
    static constexpr float kMinHalf2 = 1e-20f;

    BxDFFlags Sharpness() const {
        return facets.IsSmooth() ? BxDFFlags::Specular : BxDFFlags::Glossy;
    }
    SampledSpectrum Fr(float cosTheta) const { return FrConductor(cosTheta, eta, k); }

    SampledSpectrum eta, k;
    TrowbridgeReitz facets;
};
static_assert(BxDFType<ConductorBxDF>);

}  // namespace pbrt
