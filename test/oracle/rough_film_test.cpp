// The mean over a film's thickness in closed form against the mean itself.

#include "oracle/rough_film.h"

#include <gtest/gtest.h>

#include <random>

#include "pbrt/feather/dispersion.h"
#include "pbrt/feather/thin_film.h"

namespace pbrt::oracle {
namespace {

using feather::Film;
using feather::Nm;

RoughFilm Keratin(double thickness, double deviation, double lambda) {
    return {{lambda, thickness, feather::KeratinIndex(Nm<double>{lambda})}, deviation};
}
Film<double> ModelOf(const RoughFilm &f) {
    return {{f.film.lambda}, {f.film.thickness}, f.film.index, {f.deviation}};
}
double Cosine(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180);
}

// Figures computed beside the closed form by a programme of their own, eight digits.
TEST(RoughFilm, Table) {
    struct Row {
        double thickness, deviation, lambda, degrees, closed, brute, s, p, fast;
    };
    constexpr Row table[] = {
        {590, 0, 550, 0, .13160950, .13160950, .86839050, .86839050, .86839050},
        {590, 10, 550, 0, .12874987, .12874422, .87125013, .87125013, .87063458},
        {590, 20, 450, 0, .04160617, .04161779, .95839383, .95839383, .95635469},
        {590, 10, 450, 45, .16213173, .16210390, .71030073, .96543581, .70801461},
        {530, 40, 600, 60, .17400050, .17349604, .65447500, .99752401, .61377216},
        {595, 10, 500, 60, .04011745, .04018121, .92010307, .99966203, .91398631},
        {650, 20, 400, 75, .19474526, .17897106, .66899908, .94151040, .59148065},
        {590, 10, 550, 85, .92772649, .92788623, .02239447, .12215256, .02219253}};
    constexpr double kDigits = 5.1e-9;
    for (const Row &row : table) {
        const RoughFilm f = Keratin(row.thickness, row.deviation, row.lambda);
        const double c = Cosine(row.degrees);
        const Film<double> model = ModelOf(f);
        EXPECT_NEAR(model.Reflectance(c), row.closed, kDigits);
        EXPECT_NEAR(model.Transmittance(c).s, row.s, kDigits);
        EXPECT_NEAR(model.Transmittance(c).p, row.p, kDigits);
        EXPECT_NEAR(TransmittanceOfMeanSine(f, c, Polarisation::S), row.fast, kDigits);
        const double brute =
            row.deviation > 0 ? MeanReflectance(f, c) : Unpolarised<AirySum>(f.film, c).r;
        EXPECT_NEAR(brute, row.brute, kDigits);
    }
}

struct Errors {
    double rms, most;
};
/// Errors of unpolarised reflectance, over films of 100 to 2000 nm and visible light.
Errors ErrorsOf(double least, double steepest, double roughest) {
    std::mt19937_64 random(1);
    const auto uniform = [&](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    constexpr int kCases = 1500;
    Errors errors{0, 0};
    for (int k = 0; k < kCases; ++k) {
        const double d = uniform(100, 2000), s = uniform(1e-3, roughest);
        const RoughFilm f = Keratin(d, s, uniform(380, 780));
        const double c = Cosine(uniform(least, steepest));
        const double error = ModelOf(f).Reflectance(c) - MeanReflectance(f, c);
        errors.rms += error * error / kCases;
        errors.most = std::max(errors.most, std::abs(error));
    }
    return {std::sqrt(errors.rms), errors.most};
}

// MODEL section 10's table. rms over 1500 films scatters by a third, for few of them err most; the
// largest is another one's each time.
TEST(RoughFilm, ErrsAsTheModelSays) {
    struct Row {
        double least, steepest;
        Errors ten, forty;
    };
    constexpr Row table[] = {{0, 45, {2.8e-6, 2e-5}, {3e-5, 2e-4}},
                             {45, 60, {2e-5, 2e-4}, {3e-4, 1.3e-3}},
                             {60, 75, {1.6e-4, 1.6e-3}, {2e-3, 1.1e-2}},
                             {75, 85, {2e-3, 3e-2}, {1.1e-2, 6e-2}}};
    for (const Row &row : table) {
        const auto expectAtMost = [&](const Errors &found, const Errors &known) {
            EXPECT_LT(found.rms, 1.5 * known.rms) << row.least;
            EXPECT_LT(found.most, 4 * known.most) << row.least;
        };
        expectAtMost(ErrorsOf(row.least, row.steepest, 10), row.ten);
        expectAtMost(ErrorsOf(row.least, row.steepest, 40), row.forty);
    }
}

// Averaged over a fringe the film reflects what an even one does, at every angle: 2F/(1+F) per
// polarisation, whatever the deviation.
TEST(RoughFilm, MeanOverAFringeIsExact) {
    for (const double degrees : {0., 45., 70., 85., 89.})
        for (const double deviation : {3., 15., 60.}) {
            const double c = Cosine(degrees), eta = 1.55;
            const double inside = CosineInside(eta, c), period = 500 / (2 * eta * inside);
            // A periodic function: the error of the sum falls as the contrast's power.
            constexpr int kPoints = 4000;
            double s = 0, p = 0;
            for (int i = 0; i < kPoints; ++i) {
                const Film<double> film({500}, {600 + period * i / kPoints}, eta, {deviation});
                s += film.Transmittance(c).s / kPoints;
                p += film.Transmittance(c).p / kPoints;
            }
            const auto expected = [&](Polarisation way) {
                const double F = std::pow(Fresnel(way, 1, c, eta, inside).r, 2);
                return (1 - F) / (1 + F);
            };
            EXPECT_NEAR(s, expected(Polarisation::S), 1e-12) << degrees;
            EXPECT_NEAR(p, expected(Polarisation::P), 1e-12) << degrees;
        }
}

// No fringe is left.
TEST(RoughFilm, TendsToTheIncoherentSum) {
    for (const double degrees : {0., 40., 80.}) {
        const double c = Cosine(degrees), eta = 1.55, inside = CosineInside(eta, c);
        const Film<double> film({500}, {590}, eta, {1e6});
        const double F = std::pow(Fresnel(Polarisation::S, 1, c, eta, inside).r, 2);
        EXPECT_NEAR(film.Transmittance(c).s, (1 - F) / (1 + F), 1e-14);
    }
}

// TRT takes sin^2's mean: T is convex in it, so that this is never above the mean of T.
TEST(RoughFilm, MeanSinePassesLess) {
    std::mt19937_64 random(2);
    const auto uniform = [&](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    for (int k = 0; k < 300; ++k) {
        const double d = uniform(100, 1000), s = uniform(1, 40);
        const RoughFilm f = Keratin(d, s, uniform(380, 780));
        const double c = Cosine(uniform(0, 80));
        for (const Polarisation p : {Polarisation::S, Polarisation::P})
            EXPECT_LE(TransmittanceOfMeanSine(f, c, p), MeanTransmittance(f, c, p) + 1e-12);
    }
}

}  // namespace
}  // namespace pbrt::oracle
