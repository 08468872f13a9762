#pragma once

#include <array>
#include <cmath>

#include "pbrt/simd/math.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

inline constexpr int NSpectrumSamples = 4;
inline constexpr float LambdaMin = 360, LambdaMax = 830;  ///< nm
inline constexpr float CIE_Y_integral = 106.856895f;

/// One value per sampled wavelength; one SIMD register.
class SampledSpectrum {
  public:
    SampledSpectrum() = default;
    explicit SampledSpectrum(float v) : v(v) {}
    explicit SampledSpectrum(const FloatX4 &v) : v(v) {}
    explicit SampledSpectrum(const std::array<float, 4> &a) : v(a[0], a[1], a[2], a[3]) {}

    float operator[](int i) const { return v[i]; }
    void Set(int i, float x) { v.Set(i, x); }
    const FloatX4 &Values() const { return v; }

    SampledSpectrum operator+(SampledSpectrum b) const { return SampledSpectrum(v + b.v); }
    SampledSpectrum operator-(SampledSpectrum b) const { return SampledSpectrum(v - b.v); }
    SampledSpectrum operator*(SampledSpectrum b) const { return SampledSpectrum(v * b.v); }
    SampledSpectrum operator/(SampledSpectrum b) const { return SampledSpectrum(v / b.v); }
    SampledSpectrum operator*(float s) const { return SampledSpectrum(v * s); }
    SampledSpectrum operator/(float s) const { return SampledSpectrum(v * (1 / s)); }
    friend SampledSpectrum operator*(float s, SampledSpectrum a) { return a * s; }
    SampledSpectrum operator-() const { return SampledSpectrum(-v); }
    SampledSpectrum &operator+=(SampledSpectrum b) { return v += b.v, *this; }
    SampledSpectrum &operator*=(SampledSpectrum b) { return v *= b.v, *this; }
    SampledSpectrum &operator*=(float s) { return v *= s, *this; }

    /// True where some value differs from 0.
    explicit operator bool() const { return Any(v != 0.f); }
    float MaxComponentValue() const { return std::max(std::max(v[0], v[1]), std::max(v[2], v[3])); }
    float Average() const { return (v[0] + v[1] + v[2] + v[3]) * 0.25f; }
    bool IsFinite() const {
        return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]) &&
               std::isfinite(v[3]);
    }

  private:
    FloatX4 v{};
};

inline SampledSpectrum Sqrt(SampledSpectrum a) {
    return SampledSpectrum(Sqrt(a.Values()));
}
inline SampledSpectrum ClampZero(SampledSpectrum a) {
    return SampledSpectrum(Max(a.Values(), 0));
}
/// To [0, 1].
inline SampledSpectrum ClampToUnit(SampledSpectrum a) {
    return SampledSpectrum(Min(ClampZero(a).Values(), 1));
}

/// The wavelengths (nm) a path carries and the densities (1/nm) they were drawn with.
/// After TerminateSecondary only the first counts: the others have pdf 0 and must not reach the
/// film.
class SampledWavelengths {
  public:
    /// By the visible importance pdf(lambda) = 0.0039398042 / cosh^2(0.0072 (lambda - 538));
    /// the i-th wavelength uses frac(u + i/4). `u` in [0, 1).
    static SampledWavelengths SampleVisible(float u);
    /// The i-th wavelength lies i quarters of the range after the first, wrapped round.
    static SampledWavelengths SampleUniform(float u, float min = LambdaMin, float max = LambdaMax);
    /// Given ones, each with pdf 1.
    static SampledWavelengths Of(const std::array<float, NSpectrumSamples> &nanometres) {
        SampledWavelengths w;
        w.lambda = SampledSpectrum(nanometres);
        w.pdf = SampledSpectrum(1.f);
        return w;
    }

    float operator[](int i) const { return lambda[i]; }
    SampledSpectrum Lambda() const { return lambda; }
    SampledSpectrum PDF() const { return pdf; }
    bool SecondaryTerminated() const { return pdf[1] == 0 && pdf[2] == 0 && pdf[3] == 0; }
    void TerminateSecondary() {
        if (SecondaryTerminated()) return;
        pdf = SampledSpectrum(std::array<float, 4>{pdf[0] / NSpectrumSamples, 0, 0, 0});
    }

  private:
    SampledSpectrum lambda, pdf;
};

inline SampledWavelengths SampledWavelengths::SampleVisible(float u) {
    const FloatX4 shifted = u + FloatX4{0, 0.25f, 0.5f, 0.75f};
    // The inverse of the cumulative density; 1 / cosh^2(atanh(y)) is 1 - y^2.
    const FloatX4 y = 0.85691062f - 1.82750197f * Select(shifted < 1, shifted, shifted - 1);
    const FloatX4 lambda = 538 - (138.888889f / 2) * Log((1 + y) / (1 - y));
    SampledWavelengths w;
    w.lambda = SampledSpectrum(Clamp(lambda, LambdaMin, LambdaMax));
    w.pdf = SampledSpectrum(0.0039398042f * (1 - y * y));
    return w;
}

inline SampledWavelengths SampledWavelengths::SampleUniform(float u, float min, float max) {
    SampledWavelengths w;
    for (int i = 0; i < NSpectrumSamples; ++i) {
        const float shifted = u + 0.25f * i;
        w.lambda.Set(i, std::min(max, Lerp(shifted < 1 ? shifted : shifted - 1, min, max)));
    }
    w.pdf = SampledSpectrum(1 / (max - min));
    return w;
}

}  // namespace pbrt
