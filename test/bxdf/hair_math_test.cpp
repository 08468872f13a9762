#include "pbrt/bxdfs/hair_math.h"

#include <gtest/gtest.h>

#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

constexpr double kPi = 3.14159265358979323846;

double ScaledBesselI0(double x) {
    return x < 600 ? std::cyl_bessel_i(0.0, x) * std::exp(-x)
                   : (1 + 1 / (8 * x) + 9 / (128 * x * x)) / std::sqrt(2 * kPi * x);
}
/// The density in double, v of any size, as d'Eon et al. write it but for e^-a.
double ExactDensity(double theta_i, double theta_o, double v) {
    const double a = std::cos(theta_i) * std::cos(theta_o) / v;
    const double exponent = (std::cos(theta_i + theta_o) - 1) / v;
    return std::exp(exponent) * ScaledBesselI0(a) / (v * (1 - std::exp(-2 / v)));
}
Inclination At(double theta) {
    return {Broadcast<4>(float(std::sin(theta))), Broadcast<4>(float(std::cos(theta)))};
}

TEST(Longitudinal, AgainstTheFormulaInDouble) {
    Rng rng(1);
    for (float v : {1.4e-5f, 1e-3f, 0.03f, 0.1f, 0.5f, 3.f, 27.f, 110.f}) {
        const Longitudinal distribution(Broadcast<4>(v));
        for (int i = 0; i < 2000; ++i) {
            const double theta_o = kPi * (rng.Uniform() - 0.5);
            // Within 5 deviations of the mirror direction, or anywhere where the lobe is wide.
            const double theta_i = std::clamp(
                -theta_o + 10 * std::sqrt(double(v)) * (rng.Uniform() - 0.5), -kPi / 2, kPi / 2);
            const double exact = ExactDensity(theta_i, theta_o, v);
            // The sines' and cosines' own rounding, 6e-8, against the width of the lobe, and four
            // roundings of the exponent.
            const double rounding =
                6e-8 * (6 / std::sqrt(double(v)) + 4 * (1 - std::cos(theta_i + theta_o)) / v);
            EXPECT_NEAR(distribution.PDF(At(theta_i), At(theta_o))[0] / exact, 1, 1e-6 + rounding)
                << v << " " << theta_i << " " << theta_o;
        }
    }
}

TEST(Longitudinal, IsNormalised) {
    for (float v : {1.4e-5f, 1e-3f, 0.1f, 3.f, 110.f}) {
        const Longitudinal distribution(Broadcast<4>(v));
        for (double theta_o : {-1.5, -0.4, 0.0, 0.9}) {
            const int n = 200000;
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                const double theta = kPi * ((i + 0.5) / n - 0.5);
                sum += distribution.PDF(At(theta), At(theta_o))[0] * std::cos(theta);
            }
            EXPECT_NEAR(sum * kPi / n, 1, 2e-5) << v << " " << theta_o;
        }
    }
}

/// Means of sin_i and of its square over samples and over the density.
TEST(Longitudinal, SamplesFollowTheDensity) {
    for (float v : {1e-4f, 0.02f, 0.3f, 5.f}) {
        const Longitudinal distribution(Broadcast<4>(v));
        for (double theta_o : {-1.2, 0.0, 0.6}) {
            const int n = 400;
            double mean = 0, squares = 0, exactMean = 0, exactSquares = 0;
            for (int k = 0; k < n * n; ++k) {
                const Point2f u{(float(k % n) + 0.5f) / n, (float(k / n) + 0.5f) / n};
                const auto [s, c] =
                    distribution.Sample(0, float(std::sin(theta_o)), float(std::cos(theta_o)), u);
                EXPECT_NEAR(s * s + c * c, 1, 1e-6);
                mean += s / (n * n), squares += s * s / (n * n);
                const double theta = kPi * ((k + 0.5) / (n * n) - 0.5);
                const double p = ExactDensity(theta, theta_o, v) * std::cos(theta) * kPi / (n * n);
                exactMean += p * std::sin(theta), exactSquares += p * Sqr(std::sin(theta));
            }
            EXPECT_NEAR(mean, exactMean, 2e-4) << v;
            EXPECT_NEAR(squares, exactSquares, 5e-4) << v;
        }
    }
}

TEST(TrimmedLogistic, AgainstTheFormulaInDouble) {
    for (double s : {0.00174, 0.05, 0.4, 4.3}) {
        const TrimmedLogistic distribution{float(s)};
        const auto cdf = [s](double x) { return 1 / (1 + std::exp(-x / s)); };
        double sum = 0;
        const int n = 20001;
        for (int i = 0; i < n; ++i) {
            const float x = Pi * (2 * (float(i) + 0.5f) / n - 1);
            const double e = std::exp(-std::abs(double(x)) / s);
            const double exact = e / (s * Sqr(1 + e)) / (cdf(kPi) - cdf(-kPi));
            const float density = distribution.PDF(Broadcast<4>(x))[2];
            // Rounding of the exponent counts as often as it is large.
            const double tolerance = 1e-6 + 1e-7 * std::abs(x) / s;
            EXPECT_NEAR(density, exact, tolerance * exact + 1e-16 / s) << s << " " << x;
            sum += density * 2 * kPi / n;
        }
        EXPECT_NEAR(sum, 1, 1e-4);
        for (float u : {0.f, 1e-6f, 0.3f, 0.5f, 0.9f, OneMinusEpsilon}) {
            const float x = distribution.Sample(u);
            EXPECT_LE(std::abs(x), Pi);
            EXPECT_NEAR((cdf(x) - cdf(-kPi)) / (cdf(kPi) - cdf(-kPi)), u, 1e-6);
        }
    }
}

}  // namespace
}  // namespace pbrt
