#pragma once

#include <concepts>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/scene/params.h"
#include "pbrt/spectra/color.h"
#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/transform.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// The surface that a camera ray meets first, in rendering space.
struct VisibleSurface {
    Point3f p;
    Normal3f n, ns;
    Point2f uv;
    Vector3f dpdx, dpdy;     ///< per pixel step
    SampledSpectrum albedo;  ///< share of even light that is scattered towards the camera
};

/// One path's contribution to a pixel.
struct FilmSample {
    RGB rgb;                  ///< the response of the sensor (Sensor::Response)
    SampledSpectrum exposed;  ///< radiance (Sensor::Exposed); set where FilmTraits::spectral
    const SampledWavelengths &lambda;
    float weight;                   ///< of the pixel filter; may be negative
    const VisibleSurface *surface;  ///< null where nothing is seen, or FilmTraits::surface is unset
    RGB albedo;                     ///< the surface's, in the film's RGB
};

/// Data that a film type asks for beyond rgb; those left out cost nothing.
struct FilmTraits {
    bool surface = false;   ///< FilmSample::surface and albedo
    bool spectral = false;  ///< FilmSample::exposed
    bool exrOnly = false;   ///< has channels that only OpenEXR files hold
};

/// A type of film: what an image keeps besides R, G and B, which class Film sums up for all types.
/// Immutable while rendering; what is summed up is in Sums, one for each pixel.
///   kName, kTraits    the name in scene files; what it asks for
///   Create(params)    reads its own parameters; mistakes go to the dictionary's log
///   SetSpaces(c, w)   transforms from rendering to camera and to world space, before rendering
///   SampleWavelengths(u)   of one path, u in [0, 1); pdf per nm
///   NewSums()         those of a pixel without samples. Sums must consist of ExactSum, so that
///                     samples may come in any order; Sums::ForEach(f) calls f with each, in the
///                     same order always and equally often for all pixels of a film
///   Add(&sums, sample)
///   ChannelNames()    names of its channels, in the order of Write; empty: none
///   Write(sums, values)    sets one value for each channel; without samples finite, too
///   WriteMetadata(&strings)    adds text attributes of the file, name and value
template <typename F>
concept FilmType = requires(F film, const F fixed, ParamDict &params, const Transform &t, float u,
                            typename F::Sums sums, const FilmSample &sample, float *values,
                            std::map<std::string, std::string> *strings) {
    { F::kName } -> std::convertible_to<std::string_view>;
    { F::kTraits } -> std::convertible_to<FilmTraits>;
    { F::Create(params) } -> std::same_as<F>;
    film.SetSpaces(t, t);
    { fixed.SampleWavelengths(u) } -> std::same_as<SampledWavelengths>;
    { fixed.NewSums() } -> std::same_as<typename F::Sums>;
    fixed.Add(&sums, sample);
    { fixed.ChannelNames() } -> std::same_as<std::vector<std::string>>;
    fixed.Write(sums, values);
    fixed.WriteMetadata(strings);
};

}  // namespace pbrt
