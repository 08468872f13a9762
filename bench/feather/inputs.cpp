#include "bench/feather/inputs.h"

#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt::bench {
namespace {

constexpr int kTimedInputs = 2048;

}  // namespace

std::vector<Input> MakeInputs(int count, uint64_t seed) {
    Rng rng(seed);
    std::vector<Input> inputs;
    for (int i = 0; i < count; ++i) {
        const Vector3f wo = SampleUniformHemisphere(rng.Uniform2D());
        const Vector3f wi = SampleUniformHemisphere(rng.Uniform2D());
        const float uc = rng.Uniform();
        inputs.push_back({wo, wi, uc, rng.Uniform2D()});
    }
    return inputs;
}

const std::vector<Input> &TimedInputs() {
    static const std::vector<Input> inputs = MakeInputs(kTimedInputs, 1);
    return inputs;
}

std::vector<PacketInput> PackInputs(const std::vector<Input> &inputs) {
    std::vector<PacketInput> packets((inputs.size() + kPacketSize - 1) / kPacketSize);
    for (size_t i = 0; i < inputs.size(); ++i) {
        PacketInput &to = packets[i / kPacketSize];
        const int lane = int(i % kPacketSize);
        SetLane(&to.wo, lane, inputs[i].wo);
        SetLane(&to.wi, lane, inputs[i].wi);
        SetLane(&to.uc, lane, inputs[i].uc);
        SetLane(&to.u, lane, inputs[i].u);
    }
    return packets;
}

const std::vector<PacketInput> &PacketTimedInputs() {
    static const std::vector<PacketInput> inputs = PackInputs(TimedInputs());
    static_assert(kTimedInputs % kPacketSize == 0);
    return inputs;
}

}  // namespace pbrt::bench
