#include "pbrt/feather/thin_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "feather/model.h"
#include "oracle/complex_airy.h"

namespace pbrt::feather {
namespace {

Film<double> KeratinFilm(double lambda, double thickness) {
    return {{lambda}, {thickness}, KeratinIndex(Nm<double>{lambda})};
}

double Cosine(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180);
}

// Values computed independently of this code (a transfer-matrix programme), six digits.
TEST(Film, ReflectanceTable) {
    struct Row {
        double thickness, degrees, reflectance[7];
    };
    constexpr Row table[] = {
        {595, 0, {.139658, .031520, .118876, .142920, .009843, .049629, .146410}},
        {595, 60, {.061252, .271881, .031305, .159913, .270924, .241245, .120059}},
        {530, 0, {.046546, .132454, .118886, .000198, .100007, .167502, .132866}}};
    for (const Row &row : table)
        for (int i = 0; i < 7; ++i)
            EXPECT_NEAR(KeratinFilm(400 + 50 * i, row.thickness).Reflectance(Cosine(row.degrees)),
                        row.reflectance[i], 5.1e-7)
                << row.thickness << " nm, " << row.degrees << " deg, " << 400 + 50 * i << " nm";
}

/// Wavelengths between 300 and 850 nm at which the film's phase is an odd number of half turns,
/// 2 n d cos(theta_t) = (m + 1/2) lambda.
std::vector<double> HalfTurns(double thickness, double degrees) {
    const double c = Cosine(degrees), step = 0.01;
    const auto turns = [&](double lambda) {
        const Film<double> film = KeratinFilm(lambda, thickness);
        return film.turns * std::sqrt(film.excess + c * c) - 0.5;
    };
    std::vector<double> found;
    for (double l = 300; l < 850; l += step)
        if (std::floor(turns(l)) != std::floor(turns(l + step))) found.push_back(l + step / 2);
    return found;
}

TEST(Film, PeaksForThicknessAndAngle) {
    struct Row {
        double thickness, degrees;
        std::vector<double> peaks;
    };
    const Row table[] = {{530, 0, {307, 371, 472, 655}}, {530, 30, {448, 621}},
                         {530, 45, {423, 584}},          {530, 60, {396, 546}},
                         {530, 75, {376, 516}},          {595, 0, {342, 414, 528, 734}},
                         {595, 30, {394, 501, 695}},     {595, 45, {372, 472, 654}},
                         {595, 60, {442, 611}},          {595, 75, {419, 577}},
                         {650, 0, {372, 451, 576, 801}}, {650, 30, {428, 546, 759}},
                         {650, 45, {404, 514, 713}},     {650, 60, {481, 665}},
                         {650, 75, {455, 629}}};
    for (const Row &row : table) {
        const std::vector<double> found = HalfTurns(row.thickness, row.degrees);
        for (double expected : row.peaks) {
            const auto near = std::find_if(found.begin(), found.end(), [&](double l) {
                return std::abs(l - expected) <= 0.75;
            });
            ASSERT_NE(near, found.end())
                << row.thickness << " nm, " << row.degrees << " deg: no peak at " << expected;
            // There the reflectance is highest; dispersion moves its maximum by a nanometre.
            const double c = Cosine(row.degrees), d = row.thickness;
            EXPECT_GT(KeratinFilm(*near, d).Reflectance(c),
                      KeratinFilm(*near - 3, d).Reflectance(c));
            EXPECT_GT(KeratinFilm(*near, d).Reflectance(c),
                      KeratinFilm(*near + 3, d).Reflectance(c));
        }
    }
}

TEST(Film, EqualsTheComplexSeries) {
    Dice dice(1);
    for (int k = 0; k < 200000; ++k) {
        const double lambda = dice.Uniform(360, 830), thickness = dice.Uniform(0, 2000);
        const double eta = dice.Uniform(1.01, 2.5), c = dice.Uniform(0.001, 1);
        const oracle::AiryFilm series{lambda, thickness, eta};
        const auto power = [&](oracle::Polarisation p) {
            return std::norm(oracle::AirySum(series, c, p).t);
        };
        const Film<double> film({lambda}, {thickness}, eta);
        const Polarised<double> t = film.Transmittance(c);
        ASSERT_NEAR(film.Reflectance(c), oracle::Unpolarised<oracle::AirySum>(series, c).r, 1e-11);
        ASSERT_NEAR(t.s, power(oracle::Polarisation::S), 1e-11);
        ASSERT_NEAR(t.p, power(oracle::Polarisation::P), 1e-11);
    }
}

TEST(Film, ReflectsOrTransmits) {
    Dice dice(2);
    for (int k = 0; k < 100000; ++k) {
        const Film<float> film({float(dice.Uniform(360, 830))}, {float(dice.Uniform(0, 3000))},
                               float(dice.Uniform(1, 3)));
        const float c = float(std::pow(10, dice.Uniform(-6, 0)));
        const Polarised<float> t = film.Transmittance(c);
        EXPECT_NEAR(film.Reflectance(c) + (t.s + t.p) / 2, 1, 3e-7);
        EXPECT_TRUE(film.Reflectance(c) >= 0 && film.Reflectance(c) <= 1);
        EXPECT_TRUE(t.s >= 0 && t.s <= 1 && t.p >= 0 && t.p <= 1);
    }
}

// From 0 to 89.99 degrees, films up to 2 um.
TEST(Film, FloatAgainstDouble) {
    Dice dice(3);
    double worst = 0;
    for (int k = 0; k < 1000000; ++k) {
        const float lambda = float(dice.Uniform(360, 830)), d = float(dice.Uniform(0, 2000));
        const float eta = float(dice.Uniform(1.3, 1.8));
        const float c = float(k % 2 ? dice.Uniform(1.8e-4, 1) : dice.LogUniform(1.8e-4, 1));
        const double exact = Film<double>({lambda}, {d}, eta).Reflectance(c);
        worst = std::max(worst, std::abs(Film<float>({lambda}, {d}, eta).Reflectance(c) - exact));
    }
    EXPECT_LT(worst, 1e-6);
}

TEST(Film, Limits) {
    EXPECT_EQ(Film<float>({550}, {0}, 1.5f).Reflectance(0), 0);
    EXPECT_EQ(Film<float>({550}, {0}, 1.5f).Transmittance(0).s, 1);
    EXPECT_EQ(Film<float>({550}, {590}, 1).Reflectance(0.5f), 0);
    EXPECT_EQ(Film<float>({550}, {590}, 1).Reflectance(0), 0);
    EXPECT_EQ(Film<float>({550}, {590}, 1.5f).Reflectance(0), 1);
    EXPECT_EQ(Film<float>({550}, {590}, 1.5f).Transmittance(0).p, 0);
}

// n = 1.55 at normal incidence: quarter-wave maximum, and half-wave zero.
TEST(Film, ExtremesAtNormalIncidence) {
    const double quarter = 550 / (4 * 1.55);
    EXPECT_NEAR(Film<double>({550}, {quarter}, 1.55).Reflectance(1), .1699, 5e-5);
    EXPECT_NEAR(Film<double>({550}, {2 * quarter}, 1.55).Reflectance(1), 0, 1e-15);
}

// Over all phases a film reflects 2F/(1+F), F being that of one surface, either polarisation by
// itself; unpolarised that is so where both are alike, at normal incidence.
TEST(Film, ThickFilmTendsToIncoherentSum) {
    const auto [reflected, transmitted] = AverageFilm<double>(1.55).At(1);
    const double average = reflected / (reflected + transmitted), f = std::pow(.55 / 2.55, 2);
    EXPECT_NEAR(average, 2 * f / (1 + f), 1e-15);
    EXPECT_NEAR(average, .0889, 5e-5);
    double sum = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i)
        sum += Film<double>({400 + 300 * (i + 0.5) / n}, {1e5}, 1.55).Reflectance(1);
    EXPECT_NEAR(sum / n, average, 5e-4);
}
// Fresnel's reflectance of a surface, from the definition; p vanishes at Brewster's angle.
TEST(Film, AverageFilmFollowsFresnel) {
    const double eta = 1.55;
    for (double c : {0.35, 0.5, std::cos(std::atan(eta)), 0.9}) {
        const double inside = std::sqrt(1 - (1 - c * c) / (eta * eta));
        const double s = (c - eta * inside) / (c + eta * inside);
        const double p = (eta * c - inside) / (eta * c + inside);
        const double f = (s * s + p * p) / 2;
        const auto [reflected, transmitted] = AverageFilm<double>(eta).At(c);
        EXPECT_NEAR(reflected / transmitted, 2 * f / (1 - f), 1e-14);
    }
}

TEST(Film, SineSquared) {
    Dice dice(4);
    for (int k = 0; k < 1000000; ++k) {
        const float turns = float(dice.Uniform(-50, 50));
        const double x = turns - std::round(turns), s = std::sin(std::numbers::pi * x);
        ASSERT_NEAR(SinSquaredPi(turns), s * s, 4e-7 * s * s) << turns;
        ASSERT_NEAR(SinSquaredPi(double(turns)), s * s, 1e-15);
    }
}

}  // namespace
}  // namespace pbrt::feather
