#pragma once

#include <string>
#include <vector>

#include "pbrt/bsdftool/directions.h"
#include "pbrt/bsdftool/observer.h"
#include "pbrt/image/image.h"
#include "pbrt/materials/materials.h"

namespace pbrt::bsdftool {

struct LightAngles {
    float theta, phi;  ///< degrees; theta beyond 90: from below
};

struct ScatterogramOptions {
    int resolution = 256;     ///< pixels across a disc
    int subpixels = 2;        ///< each way, averaged
    bool timesCosine = true;  ///< f |cos theta| of the scattered direction, else f; 1/sr
    int wavelengths = 40;
};

/// Light of one direction and where a material scatters it. Each side is a disc seen from above:
/// the pixel at (x, y), x to the right, y up, is the direction (x, y, +-sqrt(1 - x^2 - y^2)), so
/// that f times the area of its pixels, 4 / resolution^2 each, sums to the scattered share. Linear
/// sRGB of equal-energy light by default, unscaled; 0 outside the disc. What passes straight on or
/// is mirrored exactly is no part of it.
struct LobePlot {
    LightAngles light;
    Image ownSide, otherSide;  ///< R G B
    bool hasGap = false;
    double gap = 0;  ///< share of light straight through; featherbarbule only
};

LobePlot ScatterLight(const Material &material, const LightAngles &light,
                      const ScatterogramOptions &options, const Spectrum &illuminant);

/// All plots in one image: a row for each light, its own side left, the other right.
Image Montage(const std::vector<LobePlot> &views);
/// The factor that makes the brightest pixels, but for one lit pixel of a hundred, 1.
float AutomaticExposure(const std::vector<LobePlot> &views);
/// The plots with axes and labels; a PNG file's bytes.
std::string ScatterogramSheet(const std::vector<LobePlot> &views, float exposure,
                              const std::string &title, const std::string &quantity);

}  // namespace pbrt::bsdftool
