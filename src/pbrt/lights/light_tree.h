#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pbrt/lights/light.h"
#include "pbrt/lights/light_bounds.h"

namespace pbrt {

/// A drawn light and the probability with which it was drawn.
struct SampledLight {
    int light;
    float pmf;
};

/// Tree over bounded lights, four children a node, walked by the children's importance (Conty
/// Estevez and Kulla 2018). Built by their surface area orientation heuristic.
class LightTree {
  public:
    LightTree() = default;
    /// `lights`: bounds of each light; those of power 0 are never drawn.
    explicit LightTree(std::span<const LightBounds> lights);

    bool Empty() const { return nodes.empty(); }
    /// nullopt where no light can reach the receiver. u in [0, 1).
    std::optional<SampledLight> Sample(const LightSampleContext &ctx, float u) const;
    /// Probability that Sample draws `light`.
    float PMF(const LightSampleContext &ctx, int light) const;
    size_t MemoryBytes() const {
        return nodes.capacity() * sizeof(Node) + paths.capacity() * sizeof(uint64_t);
    }

  private:
    static constexpr int kWidth = 4, kMaxLevels = 32;
    /// Weights this small are 0: below, u times the sum could round up to the sum.
    static constexpr float kLeast = 1e-30f;
    struct alignas(64) Node {
        ClusterOf<FourFloats> clusters{};
        int32_t child[kWidth]{};  ///< node, or ~light
        void Set(int i, const ClusterOf<float> &c, int32_t to);
    };
    struct Weights {
        float w[kWidth];
        float below[kWidth];  ///< sum of the weights of the children before
        float sum;
    };
    /// Not inline, so that Sample and PMF run the same instructions and agree to the last bit.
    static Weights ChildWeights(const Node &node, const LightSampleContext &ctx);
    friend class LightTreeBuilder;

    std::vector<Node> nodes;
    std::vector<uint64_t> paths;  ///< per light: child numbers from the root, two bits each
};

inline std::optional<SampledLight> LightTree::Sample(const LightSampleContext &ctx, float u) const {
    float pmf = 1;
    for (const Node *node = &nodes[0];;) {
        const Weights weights = ChildWeights(*node, ctx);
        if (!(weights.sum > kLeast)) return std::nullopt;
        // u < 1 keeps this below the sum, and so in a child of positive weight.
        const float place = u * weights.sum;
        int i = 0;
        for (int k = 1; k < kWidth; ++k)
            i += place >= weights.below[k];
        u = std::min((place - weights.below[i]) / weights.w[i], OneMinusEpsilon);
        pmf *= weights.w[i] / weights.sum;
        const int32_t child = node->child[i];
        if (child < 0) return SampledLight{~child, pmf};
        node = &nodes[size_t(child)];
    }
}

inline float LightTree::PMF(const LightSampleContext &ctx, int light) const {
    float pmf = 1;
    uint64_t path = paths[size_t(light)];
    for (int32_t at = 0;; path >>= 2) {
        const Node &node = nodes[size_t(at)];
        const Weights weights = ChildWeights(node, ctx);
        const int i = int(path & 3);
        if (!(weights.sum > kLeast && weights.w[i] > 0)) return 0;
        pmf *= weights.w[i] / weights.sum;
        at = node.child[i];
        if (at < 0) return pmf;
    }
}

}  // namespace pbrt
