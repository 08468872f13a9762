#pragma once

#include "pbrt/base/bxdf.h"
#include "pbrt/bxdfs/fresnel.h"
#include "pbrt/bxdfs/microfacet.h"

namespace pbrt {

/// Boundary between two transparent media; `eta` > 0 is the index below the surface (z < 0) over
/// that above. Smooth, or microfacets that are (Walter et al. 2007, with height-correlated masking
/// as in reflection). Radiance that crosses is scaled by (incident / transmitted index)^2.
class DielectricBxDF {
  public:
    static constexpr BxDFTraits kTraits{.regularizes = true};

    DielectricBxDF(float eta, float alphaX, float alphaY)
        : eta(eta), facets(alphaX, alphaY), isDelta(eta == 1 || facets.IsSmooth()) {}

    BxDFFlags Flags() const {
        const BxDFFlags sides =
            eta == 1 ? BxDFFlags::Transmission : BxDFFlags::Transmission | BxDFFlags::Reflection;
        return sides | Sharpness();
    }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode mode) const;
    float PDF(Vector3f wo, Vector3f wi, TransportMode mode) const;
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f u, TransportMode mode) const;
    void Regularize() {
        facets.Regularize();
        isDelta = eta == 1 || facets.IsSmooth();
    }

  private:
    /// Microfacet that takes light from wo to wi.
    struct Facet {
        Vector3f m;   ///< unit normal on wo's side
        float cos_o;  ///< wo . m, > 0
        float cos_i;  ///< wi . m, < 0 where light crosses
        bool crosses;
    };
    /// Below this length the generalised half vector is rounding error.
    static constexpr float kMinHalf = 1e-10f;

    BxDFFlags Sharpness() const { return isDelta ? BxDFFlags::Specular : BxDFFlags::Glossy; }
    /// Index on the far side of the surface over that on wo's side.
    float EtaFrom(Vector3f wo) const { return wo.z > 0 ? eta : 1 / eta; }
    static float TransportScale(TransportMode mode, float etap) {
        return mode == TransportMode::Radiance ? 1 / Sqr(etap) : 1;
    }
    /// dm / dwi of the half vector, where light crosses.
    static float HalfVectorJacobian(const Facet &facet, float etap) {
        return -facet.cos_i / Sqr(facet.cos_i + facet.cos_o / etap);
    }
    /// Fresnel's R and T at the facet. Where light crosses, wi gives the refracted angle, more
    /// exactly than Snell's law near the critical one.
    static DielectricFresnel FresnelAt(const Facet &facet, float etap) {
        const float cos_o = std::min(1.f, facet.cos_o);
        return FrDielectric(cos_o, facet.crosses ? -facet.cos_i : CosTransmitted(cos_o, etap),
                            etap);
    }
    std::optional<Facet> FacetBetween(Vector3f wo, Vector3f wi, float etap) const;
    std::optional<BSDFSample> SampleSmooth(Vector3f wo, float uc, TransportMode mode) const;

    float eta;
    TrowbridgeReitz facets;
    bool isDelta;
};
static_assert(BxDFType<DielectricBxDF>);

/// The microfacet that reflects or refracts wo into wi; none where its back would be hit.
inline std::optional<DielectricBxDF::Facet> DielectricBxDF::FacetBetween(Vector3f wo, Vector3f wi,
                                                                         float etap) const {
    const float sides = wo.z * wi.z;
    if (sides == 0 || isDelta) return {};
    const bool crosses = sides < 0;
    const Vector3f h = wo + (crosses ? etap : 1.f) * wi;
    const float length = Length(h);
    if (!(length > kMinHalf)) return {};
    // On wo's side of the surface.
    const Vector3f m = h * (std::copysign(1.f, h.z * wo.z) / length);
    const Facet facet{m, Dot(wo, m), Dot(wi, m), crosses};
    if (!(facet.cos_o > 0) || (facet.cos_i < 0) != crosses) return {};
    return facet;
}

inline SampledSpectrum DielectricBxDF::f(Vector3f wo, Vector3f wi, TransportMode mode) const {
    const float etap = EtaFrom(wo);
    const auto facet = FacetBetween(wo, wi, etap);
    if (!facet) return SampledSpectrum(0);
    const auto [R, T] = FresnelAt(*facet, etap);
    const float DG = facets.D(facet->m) * facets.GOverCosines(wo, wi);
    if (!facet->crosses) return SampledSpectrum(0.25f * R * DG);
    return SampledSpectrum(T * DG * facet->cos_o * HalfVectorJacobian(*facet, etap) *
                           TransportScale(mode, etap));
}

inline float DielectricBxDF::PDF(Vector3f wo, Vector3f wi, TransportMode) const {
    const float etap = EtaFrom(wo);
    const auto facet = FacetBetween(wo, wi, etap);
    if (!facet) return 0;
    const auto [R, T] = FresnelAt(*facet, etap);
    const float DG1 = facets.D(facet->m) * facets.G1OverCosine(wo);
    if (!facet->crosses) return 0.25f * R * DG1;
    return T * DG1 * facet->cos_o * HalfVectorJacobian(*facet, etap);
}

inline std::optional<BSDFSample> DielectricBxDF::SampleSmooth(Vector3f wo, float uc,
                                                              TransportMode mode) const {
    const float etap = EtaFrom(wo), cos_o = AbsCosTheta(wo);
    const float cos_t = CosTransmitted(cos_o, etap);
    if (cos_o < kMinDeltaCosine) return {};
    const auto [R, T] = eta == 1 ? DielectricFresnel{0, 1} : FrDielectric(cos_o, cos_t, etap);
    if (uc < R) {
        return BSDFSample{SampledSpectrum(R / cos_o),
                          {-wo.x, -wo.y, wo.z},
                          R,
                          BxDFFlags::Reflection | BxDFFlags::Specular};
    }
    if (cos_t < kMinDeltaCosine || T == 0) return {};
    const Vector3f wi{-wo.x / etap, -wo.y / etap, std::copysign(cos_t, -wo.z)};
    return BSDFSample{SampledSpectrum(T / cos_t * TransportScale(mode, etap)), wi, T,
                      BxDFFlags::Transmission | BxDFFlags::Specular, etap};
}

inline std::optional<BSDFSample> DielectricBxDF::Sample_f(Vector3f wo, float uc, Point2f u,
                                                          TransportMode mode) const {
    if (isDelta) return SampleSmooth(wo, uc, mode);
    if (wo.z == 0) return {};
    const float etap = EtaFrom(wo);
    const Vector3f m = facets.SampleVisibleNormal(wo, u);
    const float cos_o = std::min(1.f, Dot(wo, m));
    if (!(cos_o > 0)) return {};
    const float cos_t = CosTransmitted(cos_o, etap);
    const auto [R, T] = FrDielectric(cos_o, cos_t, etap);
    const float D = facets.D(m);
    if (uc < R) {
        const Vector3f wi = Reflect(wo, m);
        if (!SameHemisphere(wo, wi)) return {};
        const float share = 0.25f * R * D;
        return BSDFSample{SampledSpectrum(share * facets.GOverCosines(wo, wi)), wi,
                          share * facets.G1OverCosine(wo),
                          BxDFFlags::Reflection | BxDFFlags::Glossy};
    }
    const Vector3f wi = (cos_o / etap - cos_t) * m - wo / etap;
    if (!(wo.z * wi.z < 0) || T == 0) return {};
    const float share = T * D * cos_o * HalfVectorJacobian({m, cos_o, -cos_t, true}, etap);
    return BSDFSample{
        SampledSpectrum(share * facets.GOverCosines(wo, wi) * TransportScale(mode, etap)), wi,
        share * facets.G1OverCosine(wo), BxDFFlags::Transmission | BxDFFlags::Glossy, etap};
}

}  // namespace pbrt
