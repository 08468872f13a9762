#pragma once

#include <string>
#include <vector>

#include "pbrt/bsdftool/directions.h"
#include "pbrt/materials/materials.h"

namespace pbrt::bsdftool {

/// Values of a BSDF for one pair of directions and any number of wavelengths.
struct Evaluation {
    std::vector<double> f;  ///< 1/sr, without the cosine; R + TRT
    double pdf = 0;         ///< 1/sr; where it depends on wavelength, that of the first four
    bool hasParts = false;  ///< featherbarbule only: gap (of wo), R and TRT
    double gap = 0;
    std::vector<double> R, TRT;
};

/// Evaluates in float, as the renderer does; wavelengths (nm), at least one.
Evaluation Evaluate(const Material &material, const DirectionPair &pair,
                    const std::vector<float> &lambda);
/// Evaluates in double, with converged quadrature. Only for materials that HasOracle.
Evaluation EvaluateOracle(const Material &material, const DirectionPair &pair,
                          const std::vector<float> &lambda);
inline bool HasOracle(const Material &material) {
    return std::holds_alternative<FeatherBarbuleMaterial>(material);
}

/// One JSON object, 9 significant digits, without a line's end.
std::string JsonLine(const DirectionPair &pair, const std::vector<float> &lambda,
                     const Evaluation &e);

}  // namespace pbrt::bsdftool
