#pragma once

#include <array>

#include "pbrt/base/bxdf.h"
#include "pbrt/bxdfs/fresnel.h"
#include "pbrt/bxdfs/hair_math.h"

namespace pbrt {

/// Light scattered by a dielectric fibre with tilted scales and an absorbing inside: three lobes,
/// reflected (R), transmitted (TT), internally reflected once (TRT), and what is left as a fourth.
///
/// Marschner et al. 2003, d'Eon et al. 2011; parameters of Chiang et al. 2016, "A Practical and
/// Controllable Hair and Fur Model for Production Path Tracing"; as in Pharr 2016, "The
/// Implementation of a Hair Scattering Model". Local frame: x along the fibre, y and z across.
/// Light passes through, so the BxDF lives on the whole sphere.
class HairBxDF {
  public:
    static constexpr BxDFTraits kTraits{.evaluatesTogether = true};

    /// h: where it is hit along y, as seen from +z, in [-1, 1]. eta: index of the inside, >= 1.
    /// sigma_a: absorption per fibre radius, >= 0. beta_m, beta_n: roughness along and around the
    /// fibre, in [0.01, 1]. alpha: tilt of the scales, degrees.
    HairBxDF(float h, float eta, SampledSpectrum sigma_a, float beta_m, float beta_n, float alpha)
        : h(std::clamp(h, -1.f, 1.f)),
          gamma_o(SafeASin(h)),
          eta(eta),
          sigma_a(sigma_a),
          longitudinal(Variances(beta_m)),
          azimuthal(AzimuthalScale(beta_n)),
          tilt(Tilts(Radians(alpha))) {}

    BxDFFlags Flags() const {
        return BxDFFlags::Reflection | BxDFFlags::Transmission | BxDFFlags::Glossy;
    }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const {
        const View view = SeenFrom(wo);
        return Sum(view, Densities(view, InclinationOf(wi), Azimuth(wo, wi)), wi);
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        const View view = SeenFrom(wo);
        return pbrt::Sum(Densities(view, InclinationOf(wi), Azimuth(wo, wi)) * view.chance);
    }
    BSDFEval Evaluate(Vector3f wo, Vector3f wi, TransportMode) const {
        const View view = SeenFrom(wo);
        const FloatX4 densities = Densities(view, InclinationOf(wi), Azimuth(wo, wi));
        return {Sum(view, densities, wi), pbrt::Sum(densities * view.chance)};
    }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f u, TransportMode) const;

  private:
    static constexpr int kLobes = 4;

    /// Scattering lobes of the fibre as seen from wo.
    struct View {
        Inclination tilted;  ///< of wo, by lobe, turned by the scales
        FloatX4 phi;         ///< azimuth at which each lobe leaves, relative to wo; not of the last
        std::array<SampledSpectrum, kLobes> attenuation;  ///< A_p
        FloatX4 chance;                                   ///< of each lobe, in sampling
    };

    static FloatX4 Variances(float beta_m);
    static float AzimuthalScale(float beta_n);
    static Inclination Tilts(float alpha);
    static Point2f InclinationOf(Vector3f w) { return {w.x, std::sqrt(Sqr(w.y) + Sqr(w.z))}; }
    /// Angle from wo to wi about the fibre, in [-pi, pi].
    static float Azimuth(Vector3f wo, Vector3f wi) {
        return std::atan2(wo.y * wi.z - wo.z * wi.y, wo.y * wi.y + wo.z * wi.z);
    }
    View SeenFrom(Vector3f wo) const;
    void SetAttenuation(View *view, float sin_o, float cos_o, float sinGamma_t) const;
    /// Density of each lobe at the inclination `i` (sine, cosine) and azimuth, 1/sr.
    FloatX4 Densities(const View &view, Point2f i, float azimuth) const;
    /// f is without the cosine of the surface that stands for the fibre.
    static SampledSpectrum Sum(const View &view, FloatX4 densities, Vector3f wi);

    float h, gamma_o, eta;
    SampledSpectrum sigma_a;
    Longitudinal longitudinal;
    TrimmedLogistic azimuthal;
    Inclination tilt;  ///< sine and cosine of the angle added to wo's, by lobe
};
static_assert(BxDFType<HairBxDF>);

/// Variances of the lobes' inclinations; Chiang et al. 2016, eq. 7, TT and TRT as Marschner et al.
inline FloatX4 HairBxDF::Variances(float beta_m) {
    const float v = Sqr(0.726f * beta_m + 0.812f * Sqr(beta_m) + 3.7f * std::pow(beta_m, 20.f));
    return FloatX4{v, v / 4, 4 * v, 4 * v};
}

/// Chiang et al. 2016, eq. 8.
inline float HairBxDF::AzimuthalScale(float beta_n) {
    return std::sqrt(Pi / 8) *
           (0.265f * beta_n + 1.194f * Sqr(beta_n) + 5.372f * std::pow(beta_n, 22.f));
}

/// R turns by -2 alpha, TT by alpha, TRT by 4 alpha.
inline Inclination HairBxDF::Tilts(float alpha) {
    return {FloatX4{std::sin(-2 * alpha), std::sin(alpha), std::sin(4 * alpha), 0},
            FloatX4{std::cos(-2 * alpha), std::cos(alpha), std::cos(4 * alpha), 1}};
}

inline HairBxDF::View HairBxDF::SeenFrom(Vector3f wo) const {
    const auto [sin_o, cos_o] = InclinationOf(wo);
    View view;
    view.tilted = {sin_o * tilt.cos + cos_o * tilt.sin, Abs(cos_o * tilt.cos - sin_o * tilt.sin)};
    // Refraction in the cross-section, by Bravais' index sqrt(eta^2 - sin^2) / cos.
    const float sinGamma_t =
        std::clamp(h * cos_o / std::sqrt(std::max(Sqr(eta) - Sqr(sin_o), 1e-12f)), -1.f, 1.f);
    // 2 p gamma_t - 2 gamma_o + p pi.
    const float inside = 2 * std::asin(sinGamma_t) + Pi;
    view.phi = FloatX4{0, 1, 2, 0} * inside - 2 * gamma_o;
    SetAttenuation(&view, sin_o, cos_o, sinGamma_t);
    return view;
}

inline void HairBxDF::SetAttenuation(View *view, float sin_o, float cos_o, float sinGamma_t) const {
    const float cosGamma_o = SafeSqrt(1 - Sqr(h)), cosGamma_t = SafeSqrt(1 - Sqr(sinGamma_t));
    const float cosTheta_t = std::max(SafeSqrt(1 - Sqr(sin_o / eta)), 1e-6f);
    const auto [R, T] = FrDielectric(std::min(1.f, cos_o * cosGamma_o), eta);
    const SampledSpectrum through(Exp(sigma_a.Values() * (-2 * cosGamma_t / cosTheta_t)));
    auto &A = view->attenuation;
    A[0] = SampledSpectrum(R);
    A[1] = Sqr(T) * through;
    A[2] = A[1] * through * R;
    // The geometric series of all further reflections; 1 - R through = T + R (1 - through).
    A[3] = A[2] * through * R / (SampledSpectrum(T + 1e-30f) + (SampledSpectrum(1) - through) * R);
    const FloatX4 power{A[0].Average(), A[1].Average(), A[2].Average(), A[3].Average()};
    view->chance = power / pbrt::Sum(power);
}

inline FloatX4 HairBxDF::Densities(const View &view, Point2f i, float azimuth) const {
    constexpr float kTurn = 2 * Pi;
    const FloatX4 along = longitudinal.PDF({i.x, i.y}, view.tilted);
    const FloatX4 off = azimuth - view.phi;
    const FloatX4 around = azimuthal.PDF(off - Round(off * (1 / kTurn)) * kTurn);
    return along * FloatX4{around[0], around[1], around[2], 1 / kTurn};
}

inline SampledSpectrum HairBxDF::Sum(const View &view, FloatX4 densities, Vector3f wi) {
    const float cosine = AbsCosTheta(wi);
    if (cosine < 1e-20f) return SampledSpectrum(0);
    SampledSpectrum sum = densities[0] * view.attenuation[0];
    for (int p = 1; p < kLobes; ++p)
        sum += densities[p] * view.attenuation[size_t(p)];
    return sum / cosine;
}

inline std::optional<BSDFSample> HairBxDF::Sample_f(Vector3f wo, float uc, Point2f u,
                                                    TransportMode) const {
    const View view = SeenFrom(wo);
    int lobe = 0;
    while (lobe < kLobes - 1 && uc >= view.chance[lobe])
        uc -= view.chance[lobe++];
    uc = std::min(uc / view.chance[lobe], OneMinusEpsilon);
    const Point2f i = longitudinal.Sample(lobe, view.tilted.sin[lobe], view.tilted.cos[lobe], u);
    const float azimuth =
        lobe == kLobes - 1 ? Pi * (2 * uc - 1) : view.phi[lobe] + azimuthal.Sample(uc);
    // wo's direction across the fibre, turned by the azimuth.
    const float cos_o = InclinationOf(wo).y;
    const Point2f across = cos_o > 0 ? Point2f{wo.y / cos_o, wo.z / cos_o} : Point2f{1, 0};
    const SinCos turn = SinCosTurns(azimuth * (InvPi / 2));
    const Vector3f wi{i.x, i.y * (across.x * turn.cos - across.y * turn.sin),
                      i.y * (across.y * turn.cos + across.x * turn.sin)};
    const FloatX4 densities = Densities(view, i, azimuth);
    const float pdf = pbrt::Sum(densities * view.chance);
    const SampledSpectrum f = Sum(view, densities, wi);
    if (!(pdf > 0) || !f) return {};
    const BxDFFlags side = SameHemisphere(wo, wi) ? BxDFFlags::Reflection : BxDFFlags::Transmission;
    return BSDFSample{f, wi, pdf, side | BxDFFlags::Glossy};
}

}  // namespace pbrt
