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
    /// Children's clusters, one array per quantity, so that one pass evaluates all four.
    struct alignas(64) Node {
        float cx[kWidth]{}, cy[kWidth]{}, cz[kWidth]{}, radius2[kWidth]{};
        float ax[kWidth]{}, ay[kWidth]{}, az[kWidth]{};
        float cosTheta_o[kWidth]{}, cosTheta_e[kWidth]{}, signedPower[kWidth]{};
        int32_t child[kWidth]{};  ///< node, or ~light
        void Set(int i, const LightCluster &c, int32_t to);
    };
    struct Weights {
        float w[kWidth];
        float Sum() const { return (w[0] + w[1]) + (w[2] + w[3]); }
    };
    static Weights ChildWeights(const Node &node, const LightSampleContext &ctx);
    friend class LightTreeBuilder;

    std::vector<Node> nodes;
    std::vector<uint64_t> paths;  ///< per light: child numbers from the root, two bits each
};

inline LightTree::Weights LightTree::ChildWeights(const Node &node, const LightSampleContext &ctx) {
    Weights weights;
    const bool hasNormal = ctx.ns != Normal3f{};
    for (int i = 0; i < kWidth; ++i)
        weights.w[i] =
            Importance({node.cx[i], node.cy[i], node.cz[i]}, node.radius2[i],
                       {node.ax[i], node.ay[i], node.az[i]}, node.cosTheta_o[i], node.cosTheta_e[i],
                       node.signedPower[i], ctx.p, ctx.ns, hasNormal);
    return weights;
}

inline std::optional<SampledLight> LightTree::Sample(const LightSampleContext &ctx, float u) const {
    float pmf = 1;
    for (const Node *node = &nodes[0];;) {
        const Weights weights = ChildWeights(*node, ctx);
        const float sum = weights.Sum();
        if (!(sum > 0)) return std::nullopt;
        float left = u * sum;
        int i = 0, last = 0;
        // The last child of positive weight takes what rounding leaves over.
        for (int k = 0; k < kWidth; ++k)
            if (weights.w[k] > 0) last = k;
        while (i < last && left >= weights.w[i])
            left -= weights.w[i++];
        u = std::min(left / weights.w[i], OneMinusEpsilon);
        pmf *= weights.w[i] / sum;
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
        if (!(weights.w[i] > 0)) return 0;
        pmf *= weights.w[i] / weights.Sum();
        at = node.child[i];
        if (at < 0) return pmf;
    }
}

}  // namespace pbrt
