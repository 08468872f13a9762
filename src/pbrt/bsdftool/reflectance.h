#pragma once

#include <string>
#include <vector>

#include "pbrt/bsdftool/energy.h"
#include "pbrt/bsdftool/observer.h"

namespace pbrt::bsdftool {

/// Reflectance of a material against wavelength and angle: what is scattered to the side that the
/// light of one direction comes from.
struct ReflectanceTable {
    std::vector<float> lambda;  ///< nm, equally spaced
    float phi;                  ///< degrees
    struct Angle {
        float theta;  ///< degrees; negative: from the opposite azimuth
        Albedo energy;
        XYZ color;  ///< under the illuminant, Y = 1 for white
    };
    std::vector<Angle> angles;
    bool hasParts;  ///< R and TRT are known
};

struct ReflectanceOptions {
    std::vector<float> thetas;
    float phi = 0;
    float step = 2;  ///< nm
    int samples = 2048;
};

ReflectanceTable TabulateReflectance(const Material &material, const ReflectanceOptions &options,
                                     const Spectrum &illuminant);

/// theta,phi,lambda,reflectance and, where known, R and TRT.
std::string ReflectanceCsv(const ReflectanceTable &table);
/// The colors: theta, chromaticity x y, Y, linear sRGB.
std::string ColorTable(const ReflectanceTable &table);
/// Curves of up to seven angles, and below a strip of colors of them all; a PNG file's bytes.
std::string ReflectanceChart(const ReflectanceTable &table, const std::string &title,
                             const std::string &illuminant);

}  // namespace pbrt::bsdftool
