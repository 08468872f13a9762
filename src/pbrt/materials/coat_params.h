#pragma once

#include "pbrt/bxdfs/coat.h"
#include "pbrt/materials/roughness.h"

namespace pbrt {

/// The parameter of a coat's index of refraction: a number, or a spectrum that is one.
struct CoatEtaRows {
    FloatParam number;
    SpectrumParam spectrum;
};

/// Parameters of a coat that only absorbs.
struct CoatParams {
    float eta, depth;  ///< see Coat

    /// Reads `rows`, `thickness`, `albedo` (which must be 0) and `g`, `maxdepth` and `nsamples`,
    /// which have no effect, for nothing is left to chance.
    static CoatParams Get(ParamDict &params, const NamedTextures &named, const CoatEtaRows &rows);
    /// For the boundary's roughness, constant or not.
    Coat CoatWith(const Roughness &roughness) const;
};

}  // namespace pbrt
