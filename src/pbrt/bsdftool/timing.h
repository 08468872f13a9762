#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/util/vecmath.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt::bsdftool {

/// Two directions, uniform on the upper hemisphere, and numbers to sample with.
struct BenchInput {
    Vector3f wo, wi;
    float uc;
    Point2f u;
};
std::vector<BenchInput> BenchInputs(int count, uint64_t seed);
/// What all timers run over: few enough to stay in the second-level cache.
const std::vector<BenchInput> &TimedInputs();

/// A line of `bsdftool bench`; what does not apply is left out.
struct BenchRow {
    std::string name;
    // Nanoseconds per call, four wavelengths, one thread.
    std::optional<double> f, pdf, sample;
    std::optional<double> draw;  ///< Sample_f without f
    /// rms errors of TRT over pairs of directions of the upper hemisphere, relative to its mean: of
    /// the light in it (times both cosines, what a picture sees), and of f.
    std::optional<double> lightError, fError;
    std::optional<double> filmError;              ///< largest, absolute, of a film's reflectance
    std::optional<double> partR, partPdf, partT;  ///< as PartErrors
};

/// What is to be timed for a row: `pass` runs once over the inputs and returns ns per call.
struct Timer {
    std::optional<double> BenchRow::*cell;
    std::function<double()> pass;
};
struct BenchCase {
    BenchRow row;
    std::vector<Timer> timers;
};

/// Pairs, sixteen side by side; the last lanes may be empty.
struct WideBenchInput {
    Vector3fX16 wo{}, wi{};
    FloatX16 uc{};
    Point2fX16 u{};
};
std::vector<WideBenchInput> PackInputs(const std::vector<BenchInput> &inputs);
const std::vector<WideBenchInput> &WideTimedInputs();

/// Nanoseconds per input of `call` for each of the inputs, `inEach` side by side in every one.
template <typename Sum, typename Input, typename F>
double TimeOf(const std::vector<Input> &inputs, int inEach, F &call) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Sum sum{};
    for (const Input &input : inputs)
        sum += call(input);
    [[maybe_unused]] volatile Sum sink = sum;
    const std::chrono::duration<double, std::nano> time = Clock::now() - start;
    return time.count() / (double(inEach) * double(inputs.size()));
}

/// A pass that calls `call` for each of TimedInputs. `call` turns an input into a number that
/// depends on all it computed, lest the compiler leave it out.
template <typename F>
std::function<double()> Pass(F call) {
    return [call]() mutable { return TimeOf<float>(TimedInputs(), 1, call); };
}
/// As Pass, sixteen inputs a call; ns per input. `call` turns them into numbers by lane.
template <typename F>
std::function<double()> WidePass(F call) {
    return [call]() mutable { return TimeOf<FloatX16>(WideTimedInputs(), kPacketSize, call); };
}

/// All timers in turns, three passes each (the first warms the caches), so that a busy machine
/// slows them alike; the fastest pass of all rounds goes into the rows.
void RunTimers(std::vector<BenchCase> &cases, int rounds);

}  // namespace pbrt::bsdftool
