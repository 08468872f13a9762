#pragma once

#include <cstdint>
#include <vector>

#include "pbrt/util/vecmath.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt::bench {

/// Two directions, uniform on the upper hemisphere, and numbers to sample with.
struct Input {
    Vector3f wo, wi;
    float uc;
    Point2f u;
};
std::vector<Input> MakeInputs(int count, uint64_t seed);
/// The inputs that all timers run over: few enough to stay in the second-level cache.
const std::vector<Input> &TimedInputs();

/// Sixteen inputs; the last lanes may be empty.
struct PacketInput {
    Vector3fX16 wo{}, wi{};
    FloatX16 uc{};
    Point2fX16 u{};
};
std::vector<PacketInput> PackInputs(const std::vector<Input> &inputs);
const std::vector<PacketInput> &PacketTimedInputs();

}  // namespace pbrt::bench
