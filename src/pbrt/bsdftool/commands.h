#pragma once

#include <array>
#include <string>
#include <vector>

#include "pbrt/bsdftool/directions.h"
#include "pbrt/bsdftool/material_source.h"

// What `bsdftool` does, one function per sub-command. Directions are of the material's own local
// frame: z the normal, x along dp/du turned by `rotation`, that is, for feathers, x across and y
// along the barbules. Textures are looked up at the middle of [0, 1]^2.
namespace pbrt::bsdftool {

/// Values of a BSDF for one pair of directions and any number of wavelengths.
struct Evaluation {
    std::vector<double> f;  ///< 1/sr, without the cosine; R + TRT
    double pdf = 0;         ///< 1/sr
    bool hasParts = false;  ///< featherbarbule only: gap (of wo), R and TRT
    double gap = 0;
    std::vector<double> R, TRT;
};
/// In float as the renderer does; the pdf is that of the first four wavelengths.
Evaluation Evaluate(const Material &material, const DirectionPair &pair,
                    const std::vector<float> &lambda);
/// In double, with converged quadrature; nullopt for materials that are written in float only.
std::optional<Evaluation> EvaluateOracle(const Material &material, const DirectionPair &pair,
                                         const std::vector<float> &lambda);

/// One JSON object per pair, 9 significant digits.
std::string JsonLine(const DirectionPair &pair, const std::vector<float> &lambda,
                     const Evaluation &e);

/// What becomes of light of one direction that falls on the material.
struct FurnaceRow {
    float theta, phi;  ///< degrees
    double reflected = 0, transmitted = 0;  ///< scattered back to wo's side, and to the other
    double R = 0, TRT = 0, gap = 0;         ///< featherbarbule only
    double absorbed = 0;
    double error = 0;  ///< standard error of the largest of them
};
/// Averages over wavelengths of equal energy; `samples` per row; a fixed seed.
std::vector<FurnaceRow> Furnace(const Material &material, const std::vector<float> &thetas,
                                const std::vector<float> &phis, int samples);
std::string FurnaceTable(const Material &material, const std::vector<FurnaceRow> &rows);

}  // namespace pbrt::bsdftool
