#pragma once

#include "pbrt/bsdftool/timing.h"
#include "pbrt/materials/materials.h"

namespace pbrt::bsdftool {

/// f, PDF and Sample_f of any material, and of featherbarbule Sample_f without f.
BenchCase CaseOf(const std::string &name, const Material &material);
/// f, PDF and Sample_f (without f, too) of featherbarbule as the renderer calls them, for sixteen
/// vertices side by side; ns per vertex.
BenchCase SideBySideCase(const FeatherBarbuleMaterial &material);
/// f, PDF and Sample_f of a hair with its default parameters.
BenchCase HairCase();
/// Reflectance of one film at the four wavelengths, as f, by the model's real arithmetic and by
/// S-eq.1 in complex numbers (float, double), with errors against the former in double.
std::vector<BenchCase> FilmCases();
/// One sinf, as f: the yardstick between machines.
BenchCase SineCase();
/// SideBySideCase, and f of featherbarbule with each quadrature of TRT that there is, the
/// renderer's first; with the error over `pairs` pairs of directions.
std::vector<BenchCase> QuadratureCases(const FeatherBarbuleMaterial &material, int pairs);

/// Largest errors of what renders (R and PDF side by side) where turns of 1e-4 change nothing of
/// what is seen.
struct PartErrors {
    double R = 0;    ///< relative to the largest of the four wavelengths
    double pdf = 0;  ///< relative
    double gap = 0;  ///< absolute, of wo up to 89.4 degrees
    int lit = 0;     ///< pairs with R > 0 that were compared
};
PartErrors MeasureParts(const FeatherBarbuleMaterial &material, int pairs);

}  // namespace pbrt::bsdftool
