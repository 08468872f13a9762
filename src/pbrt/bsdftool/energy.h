#pragma once

#include <vector>

#include "pbrt/bsdftool/directions.h"
#include "pbrt/materials/materials.h"

namespace pbrt::bsdftool {

/// Shares of the light from one direction by where it goes, vectors per wavelength.
struct Albedo {
    std::vector<double> reflected, transmitted;  ///< scattered to its own side, and to the other
    std::vector<double> R, TRT;                  ///< featherbarbule only: parts of the two above
    double gap = 0;                              ///< straight through
    double error = 0;  ///< standard error of the mean over wavelengths of `reflected`

    /// Means over the wavelengths.
    static double Mean(const std::vector<double> &shares);
    /// Share neither scattered nor passed, on average over the wavelengths. For featherbarbule it
    /// includes light that hits the feather a second time, which the model leaves out.
    double Absorbed() const { return 1 - Mean(reflected) - Mean(transmitted) - gap; }
};

/// Albedo by sampling the BSDF, `samples` at least 16 per four wavelengths, same numbers for all
/// (a rank-1 lattice, eight times with random shifts of a fixed seed). wo on either side.
Albedo AlbedoFrom(const Material &material, const LocalDirection &wo,
                  const std::vector<float> &lambda, int samples);

/// One after another at equal distances, the middles of `count` parts of [LambdaMin, LambdaMax].
std::vector<float> MiddleWavelengths(int count);

}  // namespace pbrt::bsdftool
