#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pbrt/lights/light_tree.h"
#include "pbrt/lights/lights.h"
#include "pbrt/util/alias_table.h"

namespace pbrt {

inline constexpr std::array<std::string_view, 3> kLightSamplerNames{"bvh", "power", "uniform"};

/// Chooses the light that a path vertex samples. Uniform infinite lights are never chosen.
///   uniform  each alike
///   power    by Power()
///   bvh      bounded lights by a tree of importance at the receiver; each of n infinite ones with
///            probability 1 / (n + 1), or 1 / n where there are no others
class LightSampler {
  public:
    LightSampler() = default;
    /// `name`: one of kLightSamplerNames. Lights must have been through Preprocess; they are not
    /// referred to afterwards.
    static LightSampler Create(std::string_view name, std::span<const Light> lights);

    /// The one light there is to choose, whatever u: no number need be drawn.
    std::optional<int> OnlyLight() const {
        return kind == Kind::Single ? std::optional(single) : std::nullopt;
    }
    /// Whether the receivers' normals matter.
    bool ReadsNormals() const { return kind == Kind::Tree; }
    /// nullopt where there is nothing to choose or nothing chosen could arrive. u in [0, 1).
    std::optional<SampledLight> Sample(const LightSampleContext &ctx, float u) const {
        switch (kind) {
            case Kind::None:
                return std::nullopt;
            case Kind::Single:
                return SampledLight{single, 1};
            case Kind::Uniform:
                return Pick(unbounded, u, 1 / float(unbounded.size()));
            case Kind::Power: {
                const AliasTable::IndexSample s = byPower.Sample(u);
                return SampledLight{s.index, s.pmf};
            }
            case Kind::Tree:
                break;
        }
        if (u < pInfinite) return Pick(unbounded, u / pInfinite, pEachInfinite);
        const float rest = std::min((u - pInfinite) / (1 - pInfinite), OneMinusEpsilon);
        std::optional<SampledLight> chosen = tree.Sample(ctx, rest);
        if (chosen) *chosen = {bounded[size_t(chosen->light)], chosen->pmf * (1 - pInfinite)};
        return chosen;
    }

    /// Sample for the given lanes.
    SampledLights Sample(const LightSampleContextX16 &ctx, const FloatX16 &u,
                         LaneBits lanes) const {
        SampledLights drawn;
        if (kind == Kind::Tree) {
            const LaneBits bySlot = lanes & ~BitsOf(u < pInfinite);
            drawn =
                tree.Sample(ctx, Min((u - pInfinite) / (1 - pInfinite), OneMinusEpsilon), bySlot);
            drawn.pmf *= 1 - pInfinite;
            ForEachLane(drawn.valid, [&](int i) {
                drawn.light[size_t(i)] = bounded[size_t(drawn.light[size_t(i)])];
            });
            lanes &= ~bySlot;
        }
        ForEachLane(lanes, [&](int i) {
            const auto one = Sample(ctx.At(i), u[i]);
            if (!one) return;
            drawn.light[size_t(i)] = one->light;
            drawn.pmf.Set(i, one->pmf);
            drawn.valid |= LaneBits(1) << i;
        });
        return drawn;
    }

    /// Probability that Sample draws light number `light`.
    float PMF(const LightSampleContext &ctx, int light) const {
        switch (kind) {
            case Kind::None:
                return 0;
            case Kind::Single:
                return light == single ? 1 : 0;
            case Kind::Uniform:
                return slots[size_t(light)] == kNever ? 0 : 1 / float(unbounded.size());
            case Kind::Power:
                return byPower.PMF(light);
            case Kind::Tree:
                break;
        }
        const int slot = slots[size_t(light)];
        if (slot == kNever) return 0;
        if (slot == kUnbounded) return pEachInfinite;
        return tree.PMF(ctx, slot) * (1 - pInfinite);
    }

  private:
    enum class Kind { None, Single, Uniform, Power, Tree };
    static constexpr int kNever = -1, kUnbounded = -2;

    static SampledLight Pick(const std::vector<int> &from, float u, float pmf) {
        const size_t i = std::min(size_t(u * float(from.size())), from.size() - 1);
        return {from[i], pmf};
    }
    void BuildTree(std::span<const Light> lights, std::span<const int> sampled);

    Kind kind = Kind::None;
    int single = 0;
    float pInfinite = 0, pEachInfinite = 0;
    std::vector<int> unbounded;  ///< uniform: all that are sampled; tree: the infinite ones
    std::vector<int> bounded;    ///< the tree's numbering
    std::vector<int> slots;      ///< per light: number in the tree, kUnbounded or kNever
    AliasTable byPower;
    LightTree tree;
};

}  // namespace pbrt
