#include "pbrt/bsdftool/timing.h"

#include <algorithm>

#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt::bsdftool {
namespace {

constexpr int kTimedInputs = 2048;

}  // namespace

std::vector<BenchInput> BenchInputs(int count, uint64_t seed) {
    Rng rng(seed);
    std::vector<BenchInput> inputs;
    for (int i = 0; i < count; ++i) {
        const Vector3f wo = SampleUniformHemisphere(rng.Uniform2D());
        const Vector3f wi = SampleUniformHemisphere(rng.Uniform2D());
        const float uc = rng.Uniform();
        inputs.push_back({wo, wi, uc, rng.Uniform2D()});
    }
    return inputs;
}

const std::vector<BenchInput> &TimedInputs() {
    static const std::vector<BenchInput> inputs = BenchInputs(kTimedInputs, 1);
    return inputs;
}

std::vector<WideBenchInput> PackInputs(const std::vector<BenchInput> &inputs) {
    std::vector<WideBenchInput> wide((inputs.size() + kPacketSize - 1) / kPacketSize);
    for (size_t i = 0; i < inputs.size(); ++i) {
        WideBenchInput &to = wide[i / kPacketSize];
        const int lane = int(i % kPacketSize);
        SetLane(&to.wo, lane, inputs[i].wo);
        SetLane(&to.wi, lane, inputs[i].wi);
        SetLane(&to.uc, lane, inputs[i].uc);
        SetLane(&to.u, lane, inputs[i].u);
    }
    return wide;
}

const std::vector<WideBenchInput> &WideTimedInputs() {
    static const std::vector<WideBenchInput> inputs = PackInputs(TimedInputs());
    static_assert(kTimedInputs % kPacketSize == 0);
    return inputs;
}

void RunTimers(std::vector<BenchCase> &cases, int rounds) {
    for (int round = 0; round < rounds; ++round)
        for (BenchCase &c : cases)
            for (const Timer &timer : c.timers) {
                std::optional<double> &best = c.row.*timer.cell;
                for (int pass = 0; pass < 3; ++pass) {
                    const double time = timer.pass();
                    best = best ? std::min(*best, time) : time;
                }
            }
}

}  // namespace pbrt::bsdftool
