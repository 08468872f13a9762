#pragma once

#include "pbrt/films/camera_curves.h"
#include "pbrt/spectra/color.h"
#include "pbrt/util/matrix.h"

namespace pbrt {

/// The camera's curves as spectra.
std::array<Spectrum, 3> CurvesOf(const CameraCurves &camera);

/// CIE XYZ (of the film's space) from what a camera's pixels measure, as pbrt-v4 sets it up: the
/// matrix that maps the camera's view of a color checker under `light` to the chart's colors under
/// the space's own white with the least sum of squares. So `light` is what becomes white, but for
/// the fit: white is off by 1 % or so. The integral of the green curve over `light` stands for the
/// luminance of it, in the unit of the film's XYZ (a light of 1 gives a Y of 1).
Matrix3d XYZFromCamera(const CameraCurves &camera, const Spectrum &light,
                       const RGBColorSpace &space);

}  // namespace pbrt
