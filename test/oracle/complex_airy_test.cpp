#include "oracle/complex_airy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "pbrt/feather/thin_film.h"

namespace pbrt::oracle {
namespace {

/// Films of the model's and one direction, at random.
class Films {
  public:
    explicit Films(unsigned seed) : random(seed) {}
    double Uniform(double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    }
    AiryFilm Any(double thickest) {
        return {Uniform(360, 830), Uniform(0, thickest), Uniform(1.3, 1.8)};
    }

  private:
    std::mt19937_64 random;
};

constexpr Polarisation kBoth[] = {Polarisation::S, Polarisation::P};

TEST(ComplexAiry, SeriesTendsToItsSum) {
    Films films(1);
    for (int k = 0; k < 1000; ++k) {
        const AiryFilm f = films.Any(2000);
        const double c = films.Uniform(0.2, 1);
        for (Polarisation p : kBoth) {
            const Amplitudes sum = AirySum(f, c, p), series = AirySeries(f, c, p, 60);
            EXPECT_LT(std::abs(sum.r - series.r), 1e-13);
            EXPECT_LT(std::abs(sum.t - series.t), 1e-13);
        }
    }
}

// Two derivations that share Snell's law alone. Measured: 2e-13 for cosines above 1e-3.
TEST(ComplexAiry, EqualsTheTransferMatrix) {
    Films films(2);
    double worst = 0;
    for (int k = 0; k < 100000; ++k) {
        const AiryFilm f = films.Any(2000);
        const double c = films.Uniform(1e-3, 1);
        for (Polarisation p : kBoth) {
            const Amplitudes a = AirySum(f, c, p), m = TransferMatrix(f, c, p);
            worst = std::max({worst, std::abs(std::norm(a.r) - std::norm(m.r)),
                              std::abs(std::norm(a.t) - std::norm(m.t))});
        }
    }
    EXPECT_LT(worst, 4e-13);
}

/// What one rounding does to a power: 2^-53 of the phase, and of the amplitudes' terms, times the
/// steepest slope of sin^2(phase) / (sin^2(phase) + q) in the phase, .65 / sqrt(q), with
/// q = Y / K >= 4 c^2 / (eta^2 - 1): towards grazing incidence fringes become as narrow as the
/// cosine.
double OneRounding(const AiryFilm &f, double cosine) {
    const double phase =
        2 * std::numbers::pi * f.thickness * f.index * CosineInside(f.index, cosine) / f.lambda;
    const double slope = 1 + 0.65 * std::sqrt(f.index * f.index - 1) / (2 * cosine);
    return 0x1p-53 * (1 + phase) * slope;
}
double One(const AiryFilm &, double) {
    return 1;
}

/// Worst error of the model's film in the scalar T over random cases, against a twin, in `unit`s.
template <std::floating_point T, Amplitudes twin(const AiryFilm &, double, Polarisation),
          double unit(const AiryFilm &, double)>
double WorstError(unsigned seed, double thickest, double leastCosine) {
    Films films(seed);
    double worst = 0;
    for (int k = 0; k < 100000; ++k) {
        AiryFilm f = films.Any(thickest);
        // Half of the directions crowd towards grazing incidence.
        const double u = films.Uniform(std::log(leastCosine), 0);
        const double c = T(k % 2 ? std::exp(u) : films.Uniform(leastCosine, 1));
        f = {T(f.lambda), T(f.thickness), T(f.index)};
        const feather::Film<T> model({T(f.lambda)}, {T(f.thickness)}, T(f.index));
        const feather::Polarised<T> t = model.Transmittance(T(c));
        const Amplitudes s = twin(f, c, Polarisation::S), p = twin(f, c, Polarisation::P);
        const double error =
            std::max({std::abs(model.Reflectance(T(c)) - Unpolarised<twin>(f, c).r),
                      std::abs(t.s - std::norm(s.t)), std::abs(t.p - std::norm(p.t))});
        worst = std::max(worst, error / unit(f, c));
    }
    return worst;
}

// MODEL section 3: real arithmetic is as good as complex. Model and twin make some five roundings
// each; measured over 1e6 cases: 4.4 and 6.4, with and without fused multiplication alike, which is
// 4e-13 for cosines of 1e-2.
TEST(Film, DoubleEqualsTheTransferMatrix) {
    EXPECT_LT((WorstError<double, TransferMatrix, OneRounding>(3, 2000, 1e-2)), 10);
    EXPECT_LT((WorstError<double, TransferMatrix, OneRounding>(4, 2000, 1e-3)), 10);
}
TEST(Film, DoubleEqualsTheAirySum) {
    EXPECT_LT((WorstError<double, AirySum, OneRounding>(5, 2000, 1e-2)), 10);
    EXPECT_LT((WorstError<double, AirySum, OneRounding>(6, 2000, 1e-3)), 10);
}
// From 0 to 89.99 degrees; the published code is off by up to .074 and the anchor asks for 1e-4.
TEST(Film, FloatIsNearTheTransferMatrix) {
    EXPECT_LT((WorstError<float, TransferMatrix, One>(7, 2000, 1.8e-4)), 1e-6);
}

// S-eq.3 against the product of the model's transmittances.
TEST(Film, PigmentReturnIsTheProductOfTransmittances) {
    Films films(8);
    for (int k = 0; k < 100000; ++k) {
        const AiryFilm f = films.Any(2000);
        const double in = films.Uniform(1e-3, 1), out = films.Uniform(1e-3, 1);
        const double melanin = films.Uniform(0, 1);
        const feather::Film<double> model({f.lambda}, {f.thickness}, f.index);
        const auto a = model.Transmittance(in), b = model.Transmittance(out);
        ASSERT_NEAR(
            PigmentIntensity(f, in, out, std::polar(std::sqrt(melanin), films.Uniform(0, 6))),
            melanin * (a.s * b.s + a.p * b.p) / 2, 4e-13);
    }
}

}  // namespace
}  // namespace pbrt::oracle
