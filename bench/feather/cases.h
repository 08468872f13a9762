#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/feather/inputs.h"
#include "pbrt/materials/materials.h"

namespace pbrt::bench {

/// A line of the table; cells that do not apply are empty.
struct Row {
    std::string name;
    // Nanoseconds per call, four wavelengths, one thread.
    std::optional<double> f, pdf, sample;
    std::optional<double> draw;  ///< Sample_f without f
    /// As TRTError.
    std::optional<double> lightError, fError;
    std::optional<double> filmError;              ///< largest, absolute, of a film's reflectance
    std::optional<double> partR, partPdf, partT;  ///< as PartErrors
};

/// A cell of a row that is to be timed.
struct Timer {
    std::optional<double> Row::*cell;
    std::function<double()> pass;  ///< one call for each of TimedInputs; a sum of their results
};
struct Case {
    Row row;
    std::vector<Timer> timers;
};

/// Measures all timers by one Stopwatch of so many rounds and enters the times into the rows.
void RunTimers(std::vector<Case> &cases, int rounds);

/// A pass that calls `call` for each of TimedInputs. `call` turns an input into a number that
/// depends on all it computed, lest the compiler leave it out.
template <typename F>
std::function<double()> Pass(F call) {
    return [call]() mutable {
        float sum = 0;
        for (const Input &input : TimedInputs())
            sum += call(input);
        return double(sum);
    };
}
/// As Pass, sixteen inputs a call. `call` turns them into numbers by lane.
template <typename F>
std::function<double()> PacketPass(F call) {
    return [call]() mutable {
        FloatX16 sum{};
        for (const PacketInput &input : PacketTimedInputs())
            sum += call(input);
        double total = 0;
        for (int i = 0; i < kPacketSize; ++i)
            total += sum[i];
        return total;
    };
}

/// f, PDF and Sample_f of any material, and of featherbarbule Sample_f without f.
Case CaseOf(const std::string &name, const Material &material);
/// f, PDF and Sample_f (without f, too) of featherbarbule as the renderer calls them, for sixteen
/// vertices at a time; ns per vertex.
Case PacketCase(const FeatherBarbuleMaterial &material);
/// f, PDF and Sample_f of a hair with its default parameters.
Case HairCase();
/// Reflectance of one film at the four wavelengths, as f, by the model's real arithmetic and by
/// S-eq.1 in complex numbers (float, double), with errors against the former in double.
std::vector<Case> FilmCases();
/// One sinf, as f: the yardstick between machines.
Case SineCase();
/// Parts of featherbarbule, each as f: the lobe R, PDF where the view is known, the gap fraction,
/// the making of a model, and what the renderer asks of the material at a vertex, frame included.
std::vector<Case> PartCases(const FeatherBarbuleMaterial &material);
/// PacketCase, and f of featherbarbule with each quadrature of TRT that there is, the renderer's
/// first; with the error over `pairs` pairs of directions.
std::vector<Case> QuadratureCases(const FeatherBarbuleMaterial &material, int pairs);

/// Largest errors of R and PDF as rendered, sixteen at a time, where turns of 1e-4 change nothing
/// of what is seen.
struct PartErrors {
    double R = 0;    ///< relative to the largest of the four wavelengths
    double pdf = 0;  ///< relative
    double gap = 0;  ///< absolute, of wo up to 89.4 degrees
    int lit = 0;     ///< pairs with R > 0 that were compared
};
PartErrors MeasureParts(const FeatherBarbuleMaterial &material, int pairs);

}  // namespace pbrt::bench
