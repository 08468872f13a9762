#include "pbrt/lights/light_sampler.h"

namespace pbrt {

LightSampler LightSampler::Create(std::string_view name, std::span<const Light> lights) {
    LightSampler s;
    std::vector<int> sampled;
    s.slots.assign(lights.size(), kNever);
    for (size_t i = 0; i < lights.size(); ++i) {
        if (Traits(lights[i]).neverSampled) continue;
        sampled.push_back(int(i));
        s.slots[i] = kUnbounded;
    }
    if (sampled.empty()) return s;
    if (sampled.size() == 1) {
        s.kind = Kind::Single;
        s.single = sampled[0];
    } else if (name == "uniform") {
        s.kind = Kind::Uniform;
        s.unbounded = sampled;
    } else if (name == "power") {
        s.kind = Kind::Power;
        std::vector<float> powers(lights.size());
        for (int i : sampled)
            powers[size_t(i)] = Power(lights[size_t(i)]);
        s.byPower = AliasTable(powers);
    } else {
        DCHECK(name == "bvh");
        s.kind = Kind::Tree;
        s.BuildTree(lights, sampled);
    }
    return s;
}

void LightSampler::BuildTree(std::span<const Light> lights, std::span<const int> sampled) {
    std::vector<LightBounds> bounds;
    for (int i : sampled) {
        if (const std::optional<LightBounds> b = Bounds(lights[size_t(i)])) {
            slots[size_t(i)] = int(bounded.size());
            bounded.push_back(i);
            bounds.push_back(*b);
        } else {
            unbounded.push_back(i);
        }
    }
    tree = LightTree(bounds);
    const float n = float(unbounded.size());
    pEachInfinite = unbounded.empty() ? 0 : 1 / (n + (bounds.empty() ? 0 : 1));
    pInfinite = bounds.empty() ? 1 : n / (n + 1);
}

}  // namespace pbrt
