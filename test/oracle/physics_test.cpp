// What is measured on real feathers, on the model's film. Spectra and peaks of the film itself, the
// thick film's limit and melanin's absorption are tested in test/feather.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "pbrt/feather/dispersion.h"
#include "pbrt/feather/thin_film.h"
#include "pbrt/spectra/spectrum.h"

namespace pbrt::oracle {
namespace {

double KeratinFilm(double lambda, double thickness, double degrees) {
    const feather::Nm<double> at{lambda};
    const feather::Film<double> film(at, {thickness}, feather::KeratinIndex(at));
    return film.Reflectance(std::cos(degrees * std::numbers::pi / 180));
}

struct Extremum {
    double lambda, reflectance;
};

/// Maxima (sign +1) or minima (-1) of the film's reflectance between two wavelengths, to 0.1 nm.
std::vector<Extremum> Extrema(double thickness, double degrees, double from, double to, int sign) {
    std::vector<Extremum> found;
    const double step = 0.1;
    for (double l = from; l < to; l += step) {
        const double r = KeratinFilm(l, thickness, degrees);
        if (sign * r > sign * KeratinFilm(l - step, thickness, degrees) &&
            sign * r >= sign * KeratinFilm(l + step, thickness, degrees))
            found.push_back({l, r});
    }
    return found;
}

// McGraw 2004: purple feathers have 4 peaks (two UV, blue, red), green ones 5 (two UV, violet,
// green, red). Cortices of 530 and 595 nm; a bird's range of sight, with what its feathers' UV
// peaks need.
TEST(Physics, PurpleHasFourPeaksAndGreenFive) {
    const auto purple = Extrema(530, 0, 290, 760, 1), green = Extrema(595, 0, 290, 760, 1);
    const auto between = [](const Extremum &e, double lo, double hi) {
        return e.lambda >= lo && e.lambda <= hi;
    };
    ASSERT_EQ(purple.size(), 4u);
    EXPECT_TRUE(between(purple[0], 300, 400) && between(purple[1], 300, 400));
    EXPECT_TRUE(between(purple[2], 450, 490));
    EXPECT_TRUE(between(purple[3], 620, 700));
    ASSERT_EQ(green.size(), 5u);
    EXPECT_TRUE(between(green[0], 290, 400) && between(green[1], 300, 400));
    EXPECT_TRUE(between(green[2], 380, 450));
    EXPECT_TRUE(between(green[3], 500, 560));
    EXPECT_TRUE(between(green[4], 620, 760));
}

// Osorio and Ham 2002: peaks periodic in wavenumber, 0.5 cycles/um, one near 440 and a trough near
// 500 nm. A thickness within the range of rock doves shows all three.
TEST(Physics, PeriodInWavenumberIsOsorioAndHams) {
    const double thickness = 635;
    const auto peaks = Extrema(thickness, 0, 360, 830, 1);
    ASSERT_GE(peaks.size(), 3u);
    // Dispersion makes it .48 in the violet and .50 in the red.
    const double cycles = 1e3 / peaks.front().lambda - 1e3 / peaks.back().lambda;
    EXPECT_NEAR(cycles / double(peaks.size() - 1), 0.5, 0.015);
    const auto peak = Extrema(thickness, 0, 420, 460, 1),
               trough = Extrema(thickness, 0, 480, 520, -1);
    ASSERT_EQ(peak.size(), 1u);
    ASSERT_EQ(trough.size(), 1u);
    EXPECT_NEAR(peak[0].lambda, 440, 5);
    EXPECT_NEAR(trough[0].lambda, 500, 10);
}

struct Chromaticity {
    double x, y;
};

/// Of the film's reflection under equal energy, CIE 1931.
Chromaticity UnderEqualEnergy(double thickness, double degrees) {
    const XYZ c = SpectrumToXYZ(Spectrum::DenselySampled(
        [&](double lambda) { return KeratinFilm(lambda, thickness, degrees); }));
    const double sum = double(c.X) + c.Y + c.Z;
    return {c.X / sum, c.Y / sum};
}

// Yin et al. 2006: from normal to oblique, green turns purple and purple turns green. The figures
// were computed independently, with an analytic fit to the CIE curves (Wyman, Sloan, Shirley 2013)
// whose own error moves them by up to .0012.
TEST(Physics, GreenAndPurpleSwap) {
    struct Row {
        double thickness, degrees, x, y;
    };
    constexpr Row table[] = {
        {595, 0, .247, .443}, {595, 45, .346, .236}, {530, 0, .343, .229}, {530, 60, .356, .461}};
    for (const Row &r : table) {
        const Chromaticity c = UnderEqualEnergy(r.thickness, r.degrees);
        EXPECT_NEAR(c.x, r.x, 1.5e-3) << r.thickness << " nm " << r.degrees << " deg";
        EXPECT_NEAR(c.y, r.y, 1.5e-3) << r.thickness << " nm " << r.degrees << " deg";
        // Green lies above equal energy's white (1/3, 1/3) in y, purple below.
        EXPECT_EQ(c.y > 1.0 / 3, (r.thickness == 595) == (r.degrees == 0));
    }
}

// A film much thicker than lambda^2 / (2 n d) reflects 2F/(1+F), F of one surface, for either
// polarisation and at any angle, once averaged over wavelength.
TEST(Physics, ThickFilmForgetsItsPhase) {
    constexpr double index = 1.55;
    for (const double degrees : {0, 30, 60, 80}) {
        const double c = std::cos(degrees * std::numbers::pi / 180);
        const double inside = std::sqrt(1 - (1 - c * c) / (index * index));
        const double s = std::pow((c - index * inside) / (c + index * inside), 2);
        const double p = std::pow((index * c - inside) / (index * c + inside), 2);
        const double expected = s / (1 + s) + p / (1 + p);
        double mean = 0;
        const int n = 20000;
        for (int i = 0; i < n; ++i)
            mean +=
                feather::Film<double>({400 + 300 * (i + 0.5) / n}, {1e5}, index).Reflectance(c) / n;
        EXPECT_NEAR(mean, expected, 2e-3 * expected) << degrees;
    }
}

}  // namespace
}  // namespace pbrt::oracle
