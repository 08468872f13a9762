#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pbrt/lights/light_bounds.h"

namespace pbrt {

/// A drawn light and the probability with which it was drawn.
struct SampledLight {
    int light;
    float pmf;
};

/// One drawn for each of sixteen receivers.
struct SampledLights {
    std::array<int, kPacketSize> light;
    FloatX16 pmf{};
    LaneBits valid = 0;  ///< lanes where one was drawn; the others' are undefined
};

/// Tree over bounded lights, up to sixteen children a node, walked by the children's importance
/// (Conty Estevez and Kulla 2018). Built by their surface area orientation heuristic.
class LightTree {
  public:
    LightTree() = default;
    /// `lights`: bounds of each light; those of power 0 are never drawn.
    explicit LightTree(std::span<const LightBounds> lights);

    bool Empty() const { return nodes.empty(); }
    /// nullopt where no light can reach the receiver. u in [0, 1).
    std::optional<SampledLight> Sample(const LightSampleContext &ctx, float u) const;
    /// The same for the given lanes.
    SampledLights Sample(const LightSampleContextX16 &ctx, const FloatX16 &u, LaneBits lanes) const;
    /// Probability that Sample draws `light`.
    float PMF(const LightSampleContext &ctx, int light) const;
    size_t MemoryBytes() const {
        return nodes.capacity() * sizeof(Node) + paths.capacity() * sizeof(uint64_t);
    }

  private:
    static constexpr int kMaxLevels = 16;
    /// Weights this small are 0: below, u times the sum could round up to the sum.
    static constexpr float kLeast = 1e-30f;
    struct alignas(64) Node {
        ClusterOf<FloatX16> clusters{};
        IntX16 child{};  ///< node, or ~light
        void Set(int i, const ClusterOf<float> &c, int32_t to);
    };
    struct Weights {
        FloatX16 w, upTo;  ///< the child's, and with those of all before
        float Sum() const { return upTo[kPacketSize - 1]; }
    };
    /// State of a walk down the tree to a light.
    struct Walk {
        Receiver to;
        float u;         ///< what is left of the random number
        float pmf = 1;   ///< of coming here
        int32_t at = 0;  ///< node, or ~light
    };
    /// Weights of the children where the walks of the given lanes are. Not inline, so that Sample
    /// and PMF run the same instructions and agree to the last bit.
    void ChildWeights(const Walk *walks, LaneBits lanes, Weights *weights) const;
    /// Moves the walk to a child; false where no light can reach the receiver.
    bool Choose(const Weights &weights, Walk *walk) const;
    /// Moves each walk to a child; returns the lanes where a light may reach the receiver.
    LaneBits Descend(Walk *walks, LaneBits lanes) const {
        std::array<Weights, kPacketSize> weights;
        ChildWeights(walks, lanes, weights.data());
        LaneBits lit = 0;
        ForEachLane(lanes,
                    [&](int i) { lit |= LaneBits(Choose(weights[size_t(i)], &walks[i])) << i; });
        return lit;
    }
    friend class LightTreeBuilder;

    std::vector<Node> nodes;
    std::vector<uint64_t> paths;  ///< per light: child numbers from the root, four bits each
};

inline bool LightTree::Choose(const Weights &weights, Walk *walk) const {
    const float sum = weights.Sum();
    if (!(sum > kLeast)) [[unlikely]]
        return false;
    const float place = walk->u * sum;
    // Roundings may let the sums of a few lanes fall, and one of weight 0 add to them.
    const LaneBits some = BitsOf(weights.w > 0.f), last = std::bit_floor(some);
    const int i = std::countr_zero((some & BitsOf(weights.upTo > place)) | last);
    const float w = weights.w[i], below = weights.upTo[i] - w;
    walk->u = std::clamp((place - below) / w, 0.f, OneMinusEpsilon);
    walk->pmf *= w / sum;
    walk->at = nodes[size_t(walk->at)].child[i];
    return true;
}

inline std::optional<SampledLight> LightTree::Sample(const LightSampleContext &ctx, float u) const {
    Walk walk{{ctx.p, ctx.ns}, u};
    while (walk.at >= 0)
        if (!Descend(&walk, 1)) return std::nullopt;
    return SampledLight{~walk.at, walk.pmf};
}

inline SampledLights LightTree::Sample(const LightSampleContextX16 &ctx, const FloatX16 &u,
                                       LaneBits lanes) const {
    std::array<Walk, kPacketSize> walks;
    ForEachLane(lanes, [&](int i) {
        walks[size_t(i)] = {{Lane(ctx.p, i), Lane(ctx.ns, i)}, u[i]};
    });
    SampledLights drawn;
    // All by one level, then by the next: their steps do not wait for one another.
    while (lanes != 0) {
        lanes = Descend(walks.data(), lanes);
        LaneBits ended = 0;
        ForEachLane(lanes, [&](int i) { ended |= LaneBits(walks[size_t(i)].at < 0) << i; });
        drawn.valid |= ended;
        lanes &= ~ended;
    }
    ForEachLane(drawn.valid, [&](int i) {
        drawn.light[size_t(i)] = ~walks[size_t(i)].at;
        drawn.pmf.Set(i, walks[size_t(i)].pmf);
    });
    return drawn;
}

inline float LightTree::PMF(const LightSampleContext &ctx, int light) const {
    Walk walk{{ctx.p, ctx.ns}, 0};
    for (uint64_t path = paths[size_t(light)]; walk.at >= 0; path >>= 4) {
        Weights weights;
        ChildWeights(&walk, 1, &weights);
        const int i = int(path & 15);
        if (!(weights.Sum() > kLeast && weights.w[i] > 0)) return 0;
        walk.pmf *= weights.w[i] / weights.Sum();
        walk.at = nodes[size_t(walk.at)].child[i];
    }
    return walk.pmf;
}

}  // namespace pbrt
