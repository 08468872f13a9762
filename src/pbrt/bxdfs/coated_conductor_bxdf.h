#pragma once

#include "pbrt/base/bxdf.h"
#include "pbrt/bxdfs/coat.h"
#include "pbrt/bxdfs/coated_base.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// Metal under a dielectric coat, alike on both sides. With t(w) = Coat::From(w).down, primed
/// directions inside the coat and f_m the metal's BRDF there,
///
///     f = coat's own lobe + t(wo) t(wi) / eta^2 f_m(wo', wi') + c M(wo) M(wi),
///
/// the metal's first reflection and, in the last term, what the boundary sends back to it: M(w)
/// is the share that arrives there a second time, and c makes the sum over further reflections that
/// of CoatedBase. Where both are smooth all orders are one mirror, in closed form and exact. A
/// rough boundary also widens the metal's lobe: the slopes s of two passages turn light inside by
/// (1 - 1/eta) s each, as far as slopes of variance (1 - 1/eta)^2 alpha^2 / 2 of the metal do; its
/// first reflection is scaled to what escapes (CoatedBase::Escape). The colour of later orders is
/// the metal's mean reflectance.
///
/// Errors against walks through the layers, of all light (test/bxdf/coated_conductor_test.cpp):
/// both smooth, none; smooth coat, at most .005 for metal of alpha .3 and more, .013 for .1; rough
/// coat over rougher metal .005; rough coat over metal as smooth or smoother .03 up to 48 degrees,
/// and at 78 degrees .06 (both alphas .1) to .13 (coat .3, metal a mirror).
class CoatedConductorBxDF {
  public:
    static constexpr BxDFTraits kTraits{.regularizes = true};

    struct Alphas {
        float x, y;
        bool IsSmooth() const { return std::max(x, y) < Coat::kSmooth; }
    };
    /// eta and k of the metal relative to the coat's index. `base`'s widths must hold those of
    /// BaseAlphas; both objects must outlive this.
    CoatedConductorBxDF(SampledSpectrum eta, SampledSpectrum k, const Coat &coat,
                        const CoatedBase &base, Alphas coatAlphas, Alphas baseAlphas);

    /// Widths of the metal's lobe as seen through a boundary of these alphas.
    static Alphas WidenedBy(Alphas coat, float coatEta, Alphas base) {
        const float share = 0.5f * Sqr(1 - 1 / coatEta);
        const Alphas widened{std::sqrt(Sqr(base.x) + share * Sqr(coat.x)),
                             std::sqrt(Sqr(base.y) + share * Sqr(coat.y))};
        // Beside a rough coat the metal is no delta lobe.
        if (!widened.IsSmooth() || coat.IsSmooth()) return widened;
        return {Coat::kSmooth, Coat::kSmooth};
    }

    BxDFFlags Flags() const {
        if (isMirror) return BxDFFlags::Reflection | BxDFFlags::Specular;
        return BxDFFlags::Reflection | BxDFFlags::Glossy | BxDFFlags::Diffuse |
               (coatFacets.IsSmooth() ? BxDFFlags::Specular : BxDFFlags::Unset);
    }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const {
        if (isMirror || !SameHemisphere(wo, wi)) return SampledSpectrum(0);
        return Value(Enter(wo), wo, wi);
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        if (isMirror || !SameHemisphere(wo, wi)) return 0;
        return PDF(Enter(wo), wo, wi);
    }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f u, TransportMode) const;

    void Regularize() {
        coatFacets.Regularize();
        baseFacets.Regularize();
        isMirror = false;
    }

  private:
    /// A direction's way into the coat.
    struct Entry {
        Coat::Split split;
        Vector3f inside;  ///< up, on w's side
        float twice;      ///< M
        float escape;     ///< see CoatedBase
    };
    struct Chances {
        float coat, base;  ///< the rest: later orders
    };

    Entry Enter(Vector3f w) const {
        const float cos_t = CosTransmitted(std::min(AbsCosTheta(w), 1.f), coat->Eta());
        const Coat::Split split = coat->From(AbsCosTheta(w), coatAlpha);
        return {split,
                {w.x / coat->Eta(), w.y / coat->Eta(), std::copysign(cos_t, w.z)},
                split.down * base->Returned(cos_t, baseAlpha),
                base->Escape(cos_t, baseAlpha)};
    }
    Chances ChancesFrom(const Entry &o) const {
        const float first = std::max(0.f, o.split.down - o.twice) * meanFresnel;
        const float sum = o.split.back + first + o.twice * laterShare;
        if (!(sum > 0)) return {1, 0};
        return {o.split.back / sum, first / sum};
    }
    SampledSpectrum Value(const Entry &o, Vector3f wo, Vector3f wi) const;
    float PDF(const Entry &o, Vector3f wo, Vector3f wi) const;
    SampledSpectrum MirrorReflectance(float cosTheta) const;

    SampledSpectrum eta, k;
    const Coat *coat;
    const CoatedBase *base;
    TrowbridgeReitz coatFacets, baseFacets;
    float coatAlpha, baseAlpha;  ///< means over the azimuths
    float depth;
    bool isMirror;
    SampledSpectrum laterFactor;  ///< c
    float laterShare;             ///< largest share of what arrives twice that leaves
    float meanFresnel;            ///< largest mean reflectance of the metal
};
static_assert(BxDFType<CoatedConductorBxDF>);

inline CoatedConductorBxDF::CoatedConductorBxDF(SampledSpectrum eta, SampledSpectrum k,
                                                const Coat &coat, const CoatedBase &base,
                                                Alphas coatAlphas, Alphas baseAlphas)
    : eta(eta),
      k(k),
      coat(&coat),
      base(&base),
      coatFacets(coatAlphas.x, coatAlphas.y),
      baseFacets([&] {
          const Alphas widened = WidenedBy(coatAlphas, coat.Eta(), baseAlphas);
          return TrowbridgeReitz(widened.x, widened.y);
      }()),
      coatAlpha(std::sqrt((Sqr(coatAlphas.x) + Sqr(coatAlphas.y)) / 2)),
      depth(coat.Depth()),
      isMirror(coatAlphas.IsSmooth() && baseAlphas.IsSmooth()) {
    const Alphas widened = WidenedBy(coatAlphas, coat.Eta(), baseAlphas);
    baseAlpha = std::sqrt((Sqr(widened.x) + Sqr(widened.y)) / 2);
    // The cosine at which Fresnel's reflectance is about its mean over the hemisphere.
    const SampledSpectrum F = FrConductor(2 / 3.f, eta, k);
    const CoatedBase::Later mean = base.Mean(baseAlpha);
    const SampledSpectrum share = mean.Sum(F);
    laterFactor = mean.twice > 1e-30f ? share * (InvPi / mean.twice) : SampledSpectrum(0);
    laterShare = share.MaxComponentValue();
    meanFresnel = F.MaxComponentValue();
}

inline SampledSpectrum CoatedConductorBxDF::Value(const Entry &o, Vector3f wo, Vector3f wi) const {
    const Entry i = Enter(wi);
    SampledSpectrum f = (o.twice * i.twice) * laterFactor;
    const Vector3f h = o.inside + i.inside;
    if (const float h2 = LengthSquared(h); h2 > 1e-20f) {
        const float facets = 0.25f * baseFacets.D(h) * baseFacets.GOverCosines(o.inside, i.inside);
        f += FrConductor(std::min(1.f, 0.5f * std::sqrt(h2)), eta, k) *
             (facets * o.split.down * i.split.down * std::sqrt(o.escape * i.escape) /
              Sqr(coat->Eta()));
    }
    if (!coatFacets.IsSmooth()) {
        const Vector3f m = wo + wi;
        const float R = FrDielectric(std::min(1.f, Dot(wo, m) / Length(m)), coat->Eta()).R;
        f += SampledSpectrum(0.25f * R * coatFacets.D(m) * coatFacets.GOverCosines(wo, wi));
    }
    return f;
}

inline float CoatedConductorBxDF::PDF(const Entry &o, Vector3f wo, Vector3f wi) const {
    const Chances chance = ChancesFrom(o);
    const float later = std::max(0.f, 1 - chance.coat - chance.base);
    float pdf = later * CosineHemispherePDF(AbsCosTheta(wi));
    const float etaCoat = coat->Eta();
    const float cos_i = CosTransmitted(std::min(AbsCosTheta(wi), 1.f), etaCoat);
    const Vector3f inside{wi.x / etaCoat, wi.y / etaCoat, std::copysign(cos_i, wi.z)};
    if (const Vector3f h = o.inside + inside; LengthSquared(h) > 1e-20f)
        pdf += chance.base * 0.25f * baseFacets.D(h) * baseFacets.G1OverCosine(o.inside) *
               AbsCosTheta(wi) / (Sqr(etaCoat) * cos_i);
    if (!coatFacets.IsSmooth())
        pdf += chance.coat * 0.25f * coatFacets.D(wo + wi) * coatFacets.G1OverCosine(wo);
    return pdf;
}

/// All orders of a smooth boundary over a smooth metal.
inline SampledSpectrum CoatedConductorBxDF::MirrorReflectance(float cosTheta) const {
    const float cos_t = CosTransmitted(cosTheta, coat->Eta());
    const auto [R, T] = FrDielectric(cosTheta, cos_t, coat->Eta());
    if (!(cos_t > 0)) return SampledSpectrum(R);
    const SampledSpectrum loop = FrConductor(cos_t, eta, k) * std::exp(-2 * depth / cos_t);
    return SampledSpectrum(R) + Sqr(T) * loop / (SampledSpectrum(1) - R * loop);
}

inline std::optional<BSDFSample> CoatedConductorBxDF::Sample_f(Vector3f wo, float uc, Point2f u,
                                                               TransportMode) const {
    const float cosTheta = std::min(AbsCosTheta(wo), 1.f);
    const Vector3f mirrored{-wo.x, -wo.y, wo.z};
    const BxDFFlags flags = BxDFFlags::Reflection;
    if (isMirror) {
        if (cosTheta < kMinDeltaCosine) return {};
        return BSDFSample{MirrorReflectance(cosTheta) / cosTheta, mirrored, 1,
                          flags | BxDFFlags::Specular};
    }
    const Entry o = Enter(wo);
    const Chances chance = ChancesFrom(o);
    Vector3f wi;
    if (uc < chance.coat) {
        if (coatFacets.IsSmooth()) {
            if (cosTheta < kMinDeltaCosine) return {};
            return BSDFSample{SampledSpectrum(o.split.back / cosTheta), mirrored, chance.coat,
                              flags | BxDFFlags::Specular};
        }
        wi = Reflect(wo, coatFacets.SampleVisibleNormal(wo, u));
    } else if (uc < chance.coat + chance.base) {
        const Vector3f up = Reflect(o.inside, baseFacets.SampleVisibleNormal(o.inside, u));
        const float sin2 = Sqr(coat->Eta()) * (Sqr(up.x) + Sqr(up.y));
        if (!SameHemisphere(o.inside, up) || !(sin2 < 1)) return {};
        wi = {up.x * coat->Eta(), up.y * coat->Eta(), std::copysign(std::sqrt(1 - sin2), wo.z)};
    } else {
        wi = SampleCosineHemisphere(u);
        wi.z = std::copysign(wi.z, wo.z);
    }
    if (!SameHemisphere(wo, wi)) return {};
    const float pdf = PDF(o, wo, wi);
    const SampledSpectrum f = Value(o, wo, wi);
    if (!(pdf > 0) || !f) return {};
    return BSDFSample{f, wi, pdf, flags | BxDFFlags::Glossy};
}

}  // namespace pbrt
