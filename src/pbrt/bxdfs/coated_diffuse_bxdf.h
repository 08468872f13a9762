#pragma once

#include "pbrt/base/bxdf.h"
#include "pbrt/bxdfs/coat.h"
#include "pbrt/bxdfs/microfacet.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// A diffuse base under a dielectric coat, alike on both sides. What the coat reflects at once is a
/// mirror's or Trowbridge-Reitz facets'; all else is, with t(w) = Coat::From(w).down and K what of
/// the base's light comes back to it,
///
///     f = t(wo) t(wi) / eta^2 * (rho / pi) / (1 - rho K),
///
/// the series of base and coat reflecting in turn, exact for a diffuse base. With constant alphas
/// the whole errs by 1.6e-3 of all light at most. Where textures make the facets longer than wide,
/// t is that of round ones with the width in w's plane of incidence: errors up to 2e-2 at alphas
/// 0.1 and 0.5 (test/bxdf/coated_diffuse_test.cpp).
class CoatedDiffuseBxDF {
  public:
    static constexpr BxDFTraits kTraits{.regularizes = true};

    /// `reflectance` of the base, in [0, 1]; alphas within those of `coat`, which must outlive
    /// this.
    CoatedDiffuseBxDF(SampledSpectrum reflectance, const Coat &coat, float alphaX, float alphaY)
        : coat(&coat),
          alphaX(alphaX),
          alphaY(alphaY),
          meanAlpha(std::sqrt((Sqr(alphaX) + Sqr(alphaY)) / 2)),
          facets(alphaX, alphaY),
          isSmooth(facets.IsSmooth()) {
        const auto [down, returned] = coat.Mean(meanAlpha);
        const SampledSpectrum series = reflectance / (SampledSpectrum(1) - returned * reflectance);
        diffuse = series * (InvPi / Sqr(coat.Eta()));
        diffuseAlbedo = Pi * diffuse.MaxComponentValue() * down;
    }

    BxDFFlags Flags() const {
        const BxDFFlags lobe = isSmooth ? BxDFFlags::Specular : BxDFFlags::Glossy;
        return BxDFFlags::Reflection | lobe | (diffuse ? BxDFFlags::Diffuse : BxDFFlags::Unset);
    }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const {
        if (!SameHemisphere(wo, wi)) return SampledSpectrum(0);
        return Value(SplitFrom(wo), wo, wi);
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        if (!SameHemisphere(wo, wi)) return 0;
        return PDF(SplitFrom(wo), wo, wi);
    }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f u, TransportMode) const;

    /// Widens the facets; what gets through the coat stays as it is.
    void Regularize() {
        facets.Regularize();
        isSmooth = false;
    }

  private:
    Coat::Split SplitFrom(Vector3f w) const {
        return coat->From(AbsCosTheta(w), alphaX == alphaY ? alphaX : AlphaTowards(w));
    }
    /// Width of the facets' slopes in the plane of w and the normal.
    float AlphaTowards(Vector3f w) const {
        const float x = Sqr(w.x), y = Sqr(w.y), across = x + y;
        return across > 0 ? std::sqrt((Sqr(alphaX) * x + Sqr(alphaY) * y) / across) : meanAlpha;
    }
    float ChanceOfLobe(const Coat::Split &o) const {
        const float both = o.back + o.down * diffuseAlbedo;
        return both > 0 ? o.back / both : 1;
    }
    SampledSpectrum Value(const Coat::Split &o, Vector3f wo, Vector3f wi) const;
    float PDF(const Coat::Split &o, Vector3f wo, Vector3f wi) const;

    const Coat *coat;
    float alphaX, alphaY, meanAlpha;  ///< as made
    TrowbridgeReitz facets;
    bool isSmooth;
    SampledSpectrum diffuse;  ///< f over t(wo) t(wi)
    float diffuseAlbedo;      ///< largest share of what reaches the base that leaves again
};
static_assert(BxDFType<CoatedDiffuseBxDF>);

inline SampledSpectrum CoatedDiffuseBxDF::Value(const Coat::Split &o, Vector3f wo,
                                                Vector3f wi) const {
    const SampledSpectrum below = (o.down * SplitFrom(wi).down) * diffuse;
    if (isSmooth) return below;
    const Vector3f h = wo + wi;
    const float cosine = std::min(1.f, Dot(wo, h) / Length(h));
    const float R = FrDielectric(cosine, coat->Eta()).R;
    return below + SampledSpectrum(0.25f * R * facets.D(h) * facets.GOverCosines(wo, wi));
}

inline float CoatedDiffuseBxDF::PDF(const Coat::Split &o, Vector3f wo, Vector3f wi) const {
    const float lobe = ChanceOfLobe(o), below = (1 - lobe) * CosineHemispherePDF(AbsCosTheta(wi));
    if (isSmooth) return below;
    return below + lobe * 0.25f * facets.D(wo + wi) * facets.G1OverCosine(wo);
}

inline std::optional<BSDFSample> CoatedDiffuseBxDF::Sample_f(Vector3f wo, float uc, Point2f u,
                                                             TransportMode) const {
    if (wo.z == 0) return {};
    const Coat::Split o = SplitFrom(wo);
    const float lobe = ChanceOfLobe(o);
    Vector3f wi;
    BxDFFlags flags = BxDFFlags::Reflection;
    if (uc >= lobe) {
        wi = SampleCosineHemisphere(u);
        wi.z = std::copysign(wi.z, wo.z);
        flags = flags | BxDFFlags::Diffuse;
    } else if (isSmooth) {
        const float cosine = AbsCosTheta(wo);
        if (cosine < kMinDeltaCosine) return {};
        return BSDFSample{SampledSpectrum(o.back / cosine),
                          {-wo.x, -wo.y, wo.z},
                          lobe,
                          flags | BxDFFlags::Specular};
    } else {
        wi = Reflect(wo, facets.SampleVisibleNormal(wo, u));
        flags = flags | BxDFFlags::Glossy;
    }
    if (!SameHemisphere(wo, wi)) return {};
    const float pdf = PDF(o, wo, wi);
    const SampledSpectrum f = Value(o, wo, wi);
    if (!(pdf > 0) || !f) return {};
    return BSDFSample{f, wi, pdf, flags};
}

}  // namespace pbrt
