#pragma once

#include <array>

#include "bench/feather/inputs.h"
#include "pbrt/bsdftool/material_source.h"
#include "pbrt/feather/pigment.h"

namespace pbrt::bench {

/// nm; all that is measured of a feather is measured at these.
inline constexpr std::array<float, NSpectrumSamples> kLambda{450, 520, 590, 660};

/// In double, TRT integrated so finely that only edges of what is seen are left as error: rms 5e-6
/// of the mean for films up to 2 um, for strongly bent barbules 1e-4.
using Oracle = feather::Barbule<double, NSpectrumSamples, feather::Converged<8, 4>>;

template <typename Model>
Model ModelOf(const FeatherBarbuleMaterial &material) {
    return material.ModelAt<Model>(bsdftool::MiddleOfTexture(), kLambda);
}

template <typename T>
feather::Direction<T> Local(Vector3f w) {
    return {T(w.x), T(w.y), T(w.z)};
}

/// The parts of f and the density of each pair of directions as the renderer finds them, sixteen
/// side by side.
struct EvaluatedLobes {
    std::vector<SampledSpectrum> R, TRT;
    std::vector<float> pdf;
};
EvaluatedLobes EvaluatePacket(const FeatherBarbuleMaterial &material,
                              const std::vector<Input> &pairs);

}  // namespace pbrt::bench
