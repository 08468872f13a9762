#pragma once

#include <array>

#include "pbrt/bsdftool/material_source.h"
#include "pbrt/bsdftool/oracle.h"
#include "pbrt/bsdftool/timing.h"

namespace pbrt::bsdftool {

/// nm; all that is measured of a feather is measured at these.
inline constexpr std::array<float, NSpectrumSamples> kBenchLambda{450, 520, 590, 660};

using Oracle = feather::Barbule<double, NSpectrumSamples, QuickOracleQuadrature>;

template <typename Model>
Model BenchModel(const FeatherBarbuleMaterial &material) {
    return material.ModelAt<Model>(MiddleOfTexture(), kBenchLambda);
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
                              const std::vector<BenchInput> &pairs);

}  // namespace pbrt::bsdftool
