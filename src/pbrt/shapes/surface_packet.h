#pragma once

#include <array>
#include <bit>

#include "pbrt/shapes/shapes.h"
#include "pbrt/util/lanes_by_type.h"

namespace pbrt {

/// Hits of sixteen rays, each with its own shape.
struct PacketHits : RayHits {
    std::array<const Shape *, kPacketSize> shape;
};

namespace detail {

using ShapeLanes = LanesByType<ShapeTypes>;

/// The lanes of type S that S::SurfacesAt can do.
template <typename S, bool kWithTangents>
LaneBits WideLanes(const PacketHits &met, const ShapeLanes &types) {
    LaneBits wide = 0;
    ForEachLane(types.Of<S>(), [&](int i) {
        const S &s = *std::get_if<S>(met.shape[size_t(i)]);
        wide |= LaneBits(s.template IsWide<kWithTangents>()) << i;
    });
    return wide;
}

template <typename S, bool kWithTangents>
[[gnu::always_inline]] inline SurfaceInteractionX16 SurfacesOf(const PacketHits &met,
                                                               LaneBits lanes) {
    ShapePacket<S> shapes;
    // One lane at least; the mask tells compilers so.
    const int first = std::countr_zero(lanes) & (kPacketSize - 1);
    for (int i = 0; i < kPacketSize; ++i)
        shapes[size_t(i)] = std::get_if<S>(met.shape[size_t(lanes >> i & 1 ? i : first)]);
    return S::template SurfacesAt<kWithTangents>(shapes, met, lanes);
}

inline void Merge(LaneBits lanes, const SurfaceInteractionX16 &from, SurfaceInteractionX16 *to) {
    const MaskX16 mask = MaskOf(lanes);
    to->p = Select(mask, from.p, to->p);
    to->pError = Select(mask, from.pError, to->pError);
    to->n = Select(mask, from.n, to->n);
    to->ns = Select(mask, from.ns, to->ns);
    to->dpdu = Select(mask, from.dpdu, to->dpdu);
    to->dpdv = Select(mask, from.dpdv, to->dpdv);
    to->dpdus = Select(mask, from.dpdus, to->dpdus);
    to->uv = Select(mask, from.uv, to->uv);
    to->faceIndex = Select(mask, from.faceIndex, to->faceIndex);
    to->startBehind = Select(mask, from.startBehind, to->startBehind);
}

/// Type by type, the rest one by one. Merging takes time, too: up to two are faster one by one.
template <bool kWithTangents>
SurfaceInteractionX16 MixedSurfaces(const PacketHits &met, LaneBits active,
                                    const ShapeLanes &types) {
    constexpr int kFewestMerged = 3;
    SurfaceInteractionX16 surfaces;
    LaneBits others = active;
    ShapeTypes::ForEach([&]<typename S>() {
        if constexpr (S::kTraits.fewestWide > 0) {
            const LaneBits wide = WideLanes<S, kWithTangents>(met, types);
            if (std::popcount(wide) < std::max(kFewestMerged, S::kTraits.fewestWide)) return;
            Merge(wide, SurfacesOf<S, kWithTangents>(met, wide), &surfaces);
            others &= ~wide;
        }
    });
    ForEachLane(others, [&](int i) {
        SetLane(&surfaces, i, SurfaceAt(*met.shape[size_t(i)], met.hit.At(i), met.RayAt(i)));
    });
    return surfaces;
}

}  // namespace detail

/// SurfaceAt for the active lanes; the others' shapes are not read and their results undefined.
/// kWithTangents: with dpdu, dpdv, dpdus, uv and faceIndex, else these are undefined.
template <bool kWithTangents>
inline SurfaceInteractionX16 SurfacePacket(const PacketHits &met, LaneBits active) {
    const detail::ShapeLanes types(met.shape, active);
    if (active == 0) return detail::MixedSurfaces<kWithTangents>(met, active, types);
    const Shape &first = *met.shape[size_t(std::countr_zero(active))];
    return Dispatch(first, [&]<typename S>(const S &) {
        if constexpr (S::kTraits.fewestWide > 0)
            if (std::popcount(active) >= S::kTraits.fewestWide &&
                detail::WideLanes<S, kWithTangents>(met, types) == active)
                return detail::SurfacesOf<S, kWithTangents>(met, active);
        return detail::MixedSurfaces<kWithTangents>(met, active, types);
    });
}

}  // namespace pbrt
