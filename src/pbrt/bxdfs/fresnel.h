#pragma once

#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Mirrors and smooth boundaries scatter nothing where |cos| is below this: F / |cos| would
/// overflow.
inline constexpr float kMinDeltaCosine = 1e-30f;

/// wo mirrored about the unit vector n.
inline Vector3f Reflect(Vector3f wo, Vector3f n) {
    return 2 * Dot(wo, n) * n - wo;
}

/// Cosine of the refracted ray with its normal; cosTheta_i in [0, 1], eta = index of the far side
/// over that of the near side. 0 at and beyond total reflection.
inline float CosTransmitted(float cosTheta_i, float eta) {
    return SafeSqrt(1 - (1 - Sqr(cosTheta_i)) / Sqr(eta));
}

/// Shares of unpolarised light that a boundary between two dielectrics reflects and transmits.
/// R + T = 1 but for rounding; T does not cancel where R is near 1.
struct DielectricFresnel {
    float R, T;
};
/// Arguments as above, cosTheta_t = CosTransmitted(cosTheta_i, eta). Born and Wolf, sec. 1.5.2.
inline DielectricFresnel FrDielectric(float cosTheta_i, float cosTheta_t, float eta) {
    if (cosTheta_t == 0) return {1, 0};
    const float parallel = 1 / (eta * cosTheta_i + cosTheta_t);
    const float perpendicular = 1 / (cosTheta_i + eta * cosTheta_t);
    const float r_p = (eta * cosTheta_i - cosTheta_t) * parallel;
    const float r_s = (cosTheta_i - eta * cosTheta_t) * perpendicular;
    return {(Sqr(r_p) + Sqr(r_s)) / 2,
            2 * eta * cosTheta_i * cosTheta_t * (Sqr(parallel) + Sqr(perpendicular))};
}
inline DielectricFresnel FrDielectric(float cosTheta_i, float eta) {
    return FrDielectric(cosTheta_i, CosTransmitted(cosTheta_i, eta), eta);
}

/// a of (a + i b)^2 from a^2 + b^2, a^2 - b^2 and 2 a b; whichever of a and b is the larger is
/// found as a root and the other from it, so nothing cancels.
inline SampledSpectrum RealPart(SampledSpectrum sum, SampledSpectrum difference,
                                SampledSpectrum two_ab) {
    const FloatX4 d = difference.Values();
    const SampledSpectrum larger = Sqrt(0.5f * (sum + SampledSpectrum(Abs(d))));
    const SampledSpectrum smaller = 0.5f * two_ab / larger;
    return SampledSpectrum(Select(d < 0, smaller.Values(), larger.Values()));
}

/// A metal's index of refraction and absorption coefficient.
struct ComplexIndex {
    SampledSpectrum eta, k;
};
/// The one with eta = 1 that reflects r at normal incidence, at most .9999:
/// R = k^2 / (4 + k^2).
inline ComplexIndex IndexOf(SampledSpectrum r) {
    const SampledSpectrum clamped(Clamp(r.Values(), 0.f, 0.9999f));
    return {SampledSpectrum(1), 2 * Sqrt(clamped) / Sqrt(SampledSpectrum(1) - clamped)};
}

/// Reflectance of unpolarised light at a metal of complex index eta + i k, relative to the near
/// side; cosTheta_i in [0, 1]. Born and Wolf, sec. 14.2, in real numbers: with
/// (a + i b)^2 = (eta + i k)^2 - sin^2, R_s = |cos - a - i b|^2 / |cos + a + i b|^2 and
/// R_p = R_s |a + i b - sin tan|^2 / |a + i b + sin tan|^2.
inline SampledSpectrum FrConductor(float cosTheta_i, SampledSpectrum eta, SampledSpectrum k) {
    const float cos2 = Sqr(cosTheta_i), sin2 = 1 - cos2;
    // Beyond, where all is reflected anyway, squares of squares would not be finite.
    eta = SampledSpectrum(Clamp(eta.Values(), 0.f, 1e8f));
    k = SampledSpectrum(Clamp(k.Values(), 0.f, 1e8f));
    const SampledSpectrum two_ab = 2 * eta * k;
    const SampledSpectrum difference = eta * eta - k * k - SampledSpectrum(sin2);  // a^2 - b^2
    const SampledSpectrum sum = Sqrt(difference * difference + two_ab * two_ab);   // a^2 + b^2
    const SampledSpectrum a = RealPart(sum, difference, two_ab);
    const SampledSpectrum even_s = sum + SampledSpectrum(cos2), odd_s = (2 * cosTheta_i) * a;
    const SampledSpectrum even_p = cos2 * sum + SampledSpectrum(Sqr(sin2)), odd_p = sin2 * odd_s;
    const SampledSpectrum minus_s = even_s - odd_s, plus_s = even_s + odd_s;
    // (R_s + R_p) / 2 over a common denominator, which is 0 only where nothing reflects: eta = 1
    // and k = 0 at grazing.
    return ClampZero(minus_s) * even_p / (plus_s * (even_p + odd_p) + SampledSpectrum(1e-30f));
}

}  // namespace pbrt
