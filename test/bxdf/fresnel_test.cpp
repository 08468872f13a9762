#include "pbrt/bxdfs/fresnel.h"

#include <gtest/gtest.h>

#include <complex>

#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

using Complex = std::complex<double>;

/// Fresnel's amplitudes with a complex index, in double.
double Reflectance(double cosTheta_i, Complex index) {
    const Complex cosTheta_t = std::sqrt(1.0 - (1 - cosTheta_i * cosTheta_i) / (index * index));
    const Complex r_p = (index * cosTheta_i - cosTheta_t) / (index * cosTheta_i + cosTheta_t);
    const Complex r_s = (cosTheta_i - index * cosTheta_t) / (cosTheta_i + index * cosTheta_t);
    return (std::norm(r_p) + std::norm(r_s)) / 2;
}

TEST(Fresnel, DielectricAgainstAmplitudes) {
    Rng rng(1);
    for (float eta : {1.5f, 1 / 1.5f, 1.001f, 4.f, 0.2f}) {
        for (int i = 0; i <= 1000; ++i) {
            const float c = i < 1000 ? std::max(1e-6f, rng.Uniform()) : 1;
            const auto [R, T] = FrDielectric(c, eta);
            EXPECT_NEAR(R, Reflectance(c, eta), 3e-5) << eta << " " << c;
            EXPECT_NEAR(R + T, 1, 1e-6);
        }
    }
}

TEST(Fresnel, DielectricLimits) {
    EXPECT_FLOAT_EQ(FrDielectric(1, 1.5f).R, 0.04f);
    EXPECT_FLOAT_EQ(FrDielectric(1, 1 / 1.5f).R, 0.04f);
    EXPECT_NEAR(FrDielectric(1e-7f, 1.5f).R, 1, 1e-6);
    // Transmittance keeps its digits where nearly all is reflected: 4 cos / sqrt(eta^2 - 1) times
    // (eta + 1 / eta) / 2.
    EXPECT_NEAR(FrDielectric(1e-7f, 1.5f).T / 1e-7,
                2 * 1.5 * std::sqrt(1 - 1 / 2.25) * (1 / (1 - 1 / 2.25) + 1 / (2.25 - 1)), 1e-5);
    EXPECT_EQ(FrDielectric(0.7f, 1 / 1.5f).R, 1) << "beyond the critical angle";
    EXPECT_EQ(FrDielectric(0.7f, 1 / 1.5f).T, 0);
    EXPECT_NEAR(CosTransmitted(0.5f, 1.5f), std::sqrt(1 - 0.75 / 2.25), 1e-7);
}

TEST(Fresnel, ConductorAgainstAmplitudes) {
    Rng rng(2);
    for (int i = 0; i < 20000; ++i) {
        SampledSpectrum eta, k;
        for (int l = 0; l < NSpectrumSamples; ++l) {
            eta.Set(l, 0.02f + 4 * rng.Uniform());
            k.Set(l, 10 * rng.Uniform());
        }
        const float c = i % 10 == 0 ? 1 : rng.Uniform();
        const SampledSpectrum R = FrConductor(c, eta, k);
        for (int l = 0; l < NSpectrumSamples; ++l)
            EXPECT_NEAR(R[l], Reflectance(c, {eta[l], k[l]}), 2e-6);
    }
}

TEST(Fresnel, ConductorLimits) {
    const auto at = [](float c, float eta, float k) {
        return FrConductor(c, SampledSpectrum(eta), SampledSpectrum(k))[0];
    };
    EXPECT_FLOAT_EQ(at(1, 1.5f, 0), 0.04f);
    EXPECT_NEAR(at(1, 0.2f, 3.9f), (0.64 + 15.21) / (1.44 + 15.21), 1e-6);
    EXPECT_NEAR(at(0, 0.2f, 3.9f), 1, 1e-6);
    EXPECT_EQ(at(0.5f, 1, 0), 0);
    EXPECT_EQ(at(0, 1, 0), 0);
    // The k that the conductor material derives from a reflectance, eta = 1.
    for (float r : {0.01f, 0.5f, 0.9999f})
        EXPECT_NEAR(at(1, 1, 2 * std::sqrt(r / (1 - r))), r, 1e-6);
}

TEST(Fresnel, ReflectKeepsTheAngle) {
    const Vector3f n = Normalize(Vector3f{1, 2, 3}), wo = Normalize(Vector3f{-1, 0.5f, 2});
    const Vector3f wi = Reflect(wo, n);
    EXPECT_NEAR(Dot(wi, n), Dot(wo, n), 1e-6);
    EXPECT_NEAR(Length(wi), 1, 1e-6);
    EXPECT_NEAR(Dot(Cross(wo, n), wi), 0, 1e-6);
}

}  // namespace
}  // namespace pbrt
