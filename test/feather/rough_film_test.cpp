// A film of varying thickness: laws of its mean, hard cases, floats. That the mean is right is the
// business of test/oracle/rough_film_test.cpp.

#include <gtest/gtest.h>

#include "feather/sixteen.h"
#include "oracle/rough_film.h"

namespace pbrt::feather {
namespace {

double Cosine(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180);
}

struct Case {
    double lambda, thickness, eta, deviation, cosine;

    template <std::floating_point T>
    Film<T> As() const {
        return {{T(lambda)}, {T(thickness)}, T(eta), {T(deviation)}};
    }
};
/// Rounded to float, so that either scalar has the same; 0 to 89.9999 degrees.
Case AnyCase(Dice &dice) {
    const auto rounded = [](double x) { return double(float(x)); };
    const double angle = dice.Uniform() < 0.5 ? dice.Uniform(0, 90) : 90 - dice.LogUniform(1e-4, 9);
    return {rounded(dice.Uniform(360, 830)), rounded(dice.Uniform(0, 2000)),
            rounded(dice.Uniform(1.3, 1.8)), rounded(dice.Uniform(0, 200)),
            rounded(std::max(Cosine(angle), 1.75e-6))};
}

TEST(RoughFilm, ReflectsOrTransmits) {
    Dice dice(5);
    for (int k = 0; k < 200000; ++k) {
        const Case c = AnyCase(dice);
        const Film<double> exact = c.As<double>();
        const Film<float> film = c.As<float>();
        const Polarised<double> t = exact.Transmittance(c.cosine);
        EXPECT_NEAR(exact.Reflectance(c.cosine) + (t.s + t.p) / 2, 1, 2e-15);
        const Polarised<float> u = film.Transmittance(float(c.cosine));
        EXPECT_NEAR(film.Reflectance(float(c.cosine)) + (u.s + u.p) / 2, 1, 1e-6);
    }
}

// The phase apart, which has its own errors: thin films, whose phase is small.
TEST(RoughFilm, FloatAgainstDouble) {
    Dice dice(6);
    double R = 0, T = 0, steepR = 0;
    for (int k = 0; k < 300000; ++k) {
        Case c = AnyCase(dice);
        c.thickness = double(float(c.thickness / 10));
        const float cosine = float(c.cosine);
        const Film<double> exact = c.As<double>();
        const Film<float> film = c.As<float>();
        const double r = std::abs(film.Reflectance(cosine) - exact.Reflectance(c.cosine));
        (c.cosine < 1.745e-4 ? steepR : R) = std::max(c.cosine < 1.745e-4 ? steepR : R, r);
        const Polarised<double> t = exact.Transmittance(c.cosine);
        const Polarised<float> u = film.Transmittance(cosine);
        T = std::max({T, std::abs(u.s / t.s - 1), std::abs(u.p / t.p - 1)});
    }
    EXPECT_LT(R, 2e-6);       // to 89.99 degrees
    EXPECT_LT(steepR, 1e-5);  // to 89.9999
    EXPECT_LT(T, 1e-4);       // relative
}

TEST(RoughFilm, OfNoDeviationIsTheEvenOne) {
    Dice dice(7);
    for (int k = 0; k < 100000; ++k) {
        Case c = AnyCase(dice);
        c.cosine = double(float(dice.Uniform(0.01, 1)));
        Case even = c;
        even.deviation = 0;
        const float cosine = float(c.cosine);
        // No more than its own formula: the same bits.
        const Film<float> film = even.As<float>();
        const Film<float> without({float(c.lambda)}, {float(c.thickness)}, float(c.eta));
        EXPECT_EQ(film.Reflectance(cosine), without.Reflectance(cosine));
        c.deviation = 1e-6;
        EXPECT_NEAR(c.As<double>().Reflectance(c.cosine), even.As<double>().Reflectance(c.cosine),
                    1e-6);
        EXPECT_NEAR(c.As<float>().Reflectance(cosine), film.Reflectance(cosine), 1e-6);
        // A rounding of sin^2, 3e-8, where 4 cosine^2 (1 - 1/eta^2) of it change T by half.
        EXPECT_NEAR(c.As<float>().twice.Weighted(1.f, cosine * cosine, cosine * cosine),
                    film.twice.Weighted(1.f, cosine * cosine, cosine * cosine), 2e-4);
    }
}

template <class T>
class RoughFilmCorners : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(RoughFilmCorners, Scalars);

TYPED_TEST(RoughFilmCorners, AreFinite) {
    using T = TypeParam;
    int wrong = 0;
    for (double thickness : {0., 1e-3, 1., 1.9, 590., 1e6})
        for (double deviation : {0., 1e-8, 1e-6, 0.5, 10., 20., 1e4, 1e6})
            for (double lambda : {360., 550., 830.})
                for (double eta : {1., 1.0000002, 1.0001, 1.55, 3., 1000.})
                    for (double c : {0., 1e-38, 1e-20, 1e-12, 1e-9, 1.7e-6, 1e-3, 0.1, 0.5, 1.}) {
                        const Film<T> film({T(lambda)}, {T(thickness)}, T(eta), {T(deviation)});
                        const T R = film.Reflectance(T(c));
                        const Polarised<T> t = film.Transmittance(T(c));
                        const T twice = film.twice.Weighted(T(1), T(c * c), T(0.3));
                        constexpr T most = 1 + 8 * std::numeric_limits<T>::epsilon();
                        wrong += !(R >= 0 && R <= most) || !(t.s >= 0 && t.s <= most) ||
                                 !(t.p >= 0 && t.p <= most) || !(twice >= 0 && twice <= T(2.0001));
                    }
    EXPECT_EQ(wrong, 0);
}

TYPED_TEST(RoughFilmCorners, HaveTheirLimits) {
    using T = TypeParam;
    const auto R = [](double thickness, double deviation, double eta, double c) {
        return Film<T>({T(550)}, {T(thickness)}, T(eta), {T(deviation)}).Reflectance(T(c));
    };
    EXPECT_EQ(R(590, 0, 1.55, 0), 1);
    EXPECT_NEAR(R(590, 10, 1.55, 0), 1, 1e-6);
    EXPECT_EQ(R(590, 10, 1, 0), 0);
    EXPECT_EQ(R(590, 10, 1, 0.5), 0);
    EXPECT_EQ(R(0, 0, 1.55, 0), 0);
    EXPECT_NEAR(R(0, 20, 1.55, 1), .0215, 5e-5);
    // No fringe is left: 2F/(1+F).
    const double F = std::pow(.55 / 2.55, 2);
    EXPECT_NEAR(R(1e6, 1e6, 1.55, 1), 2 * F / (1 + F), 1e-6);
}

/// With sin^2 given: deviations of the phase from none to all, in the closed form itself.
TYPED_TEST(RoughFilmCorners, OfAnyDamping) {
    using T = TypeParam;
    for (double sigma : {1e-8, 1e-4, 0.1, 0.7, 0.71, 2., 1e4})
        for (double sineSqr : {0., 0.3, 1.}) {
            const RoughFilmMean<T> mean(T(sigma * sigma), T(sineSqr));
            for (double F : {0., 1e-6, 0.05, 0.9, 1 - 1e-6}) {
                // level, passing and interference in proportion to 1 + F^2, 1 - F^2, 4 F^2.
                const double a = 1 + F * F, b = 1 - F * F;
                const auto [R, through] = mean.Of(T(a), T(b), T(4 * F * F), T(1));
                EXPECT_NEAR(R + through, 1, 4 * std::numeric_limits<T>::epsilon());
                EXPECT_TRUE(R >= 0 && through >= 0);
                const double x = 4 * F * F * sineSqr, y = b * b;
                const double even = x / (x + y), incoherent = 2 * F * F / (1 + F * F);
                // Damping is little if it is against what passes, too.
                if (sigma < 1e-3 * y) {
                    EXPECT_NEAR(R, even, 1e-6) << F << " " << sineSqr;
                }
                if (sigma > 1e3) {
                    EXPECT_NEAR(R, incoherent, 1e-6) << F << " " << sineSqr;
                }
            }
        }
}

// The loop over TRT's nodes takes the mean of sin^2, damped by a polynomial that is 0.2 % of the
// damping off for sigma of a radian, or 7e-4 of sin^2.
TEST(RoughFilm, TwiceThroughTheMeanSine) {
    Dice dice(8);
    for (int k = 0; k < 20000; ++k) {
        const double lambda = dice.Uniform(380, 780), d = dice.Uniform(0, 1000);
        const double s = dice.Uniform(0, 40), eta = KeratinIndex(Nm<double>{lambda});
        const double in = Cosine(dice.Uniform(0, 80)), out = Cosine(dice.Uniform(0, 80));
        const oracle::RoughFilm rough{{lambda, d, eta}, s};
        double expected = 0;
        for (const auto p : {oracle::Polarisation::S, oracle::Polarisation::P})
            expected += oracle::TransmittanceOfMeanSine(rough, in, p) *
                        oracle::TransmittanceOfMeanSine(rough, out, p);
        const Film<double> film({lambda}, {d}, eta, {s});
        EXPECT_NEAR(film.twice.Weighted(1., in * in, out * out), expected, 3e-3 * expected);
        const Film<float> rounded({float(lambda)}, {float(d)}, float(eta), {float(s)});
        EXPECT_NEAR(rounded.twice.Weighted(1.f, float(in * in), float(out * out)),
                    film.twice.Weighted(1., in * in, out * out), 1e-3);
    }
}

// Films below 2 nm count as thicker and less rough, of the same mean square.
TEST(RoughFilm, TwiceThroughAlmostNothing) {
    for (double d : {0., 0.5, 1.5, 3.})
        for (double s : {0.1, 1., 2., 20.}) {
            const oracle::RoughFilm rough{{550, d, 1.55}, s};
            const double c = 0.6;
            double expected = 0;
            for (const auto p : {oracle::Polarisation::S, oracle::Polarisation::P})
                expected += std::pow(oracle::TransmittanceOfMeanSine(rough, c, p), 2);
            const Film<double> film({550}, {d}, 1.55, {s});
            EXPECT_NEAR(film.twice.Weighted(1., c * c, c * c), expected, 1e-4 * expected);
        }
}

// Beside R of two kernels TRT's mean sine passes no more than what these pass, but for the
// polynomial.
TEST(RoughFilm, MakesNoEnergy) {
    Dice dice(9);
    for (int k = 0; k < 300000; ++k) {
        const double lambda = dice.Uniform(360, 830), eta = 1 + dice.LogUniform(1e-4, 1.5);
        const Film<double> film({lambda}, {dice.Uniform(0, 1500)}, eta, {dice.Uniform(0, 200)});
        const double c =
            Cosine(dice.Uniform() < 0.5 ? dice.Uniform(0, 89.9) : dice.Uniform(85, 89.9));
        const Polarised<double> t = film.Transmittance(c);
        ASSERT_LE(film.twice.Weighted(1., c * c, c * c), t.s * t.s + t.p * t.p + 5.2e-5);
    }
}

}  // namespace
}  // namespace pbrt::feather
