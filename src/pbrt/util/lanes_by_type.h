#pragma once

#include <array>
#include <cstdint>

#include "pbrt/simd/simd.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// Sixteen values of a family, told apart by type. Types: the family's TypeList.
template <typename Types>
class LanesByType {
  public:
    /// The values in the given lanes, but for null; others are not read.
    template <typename Variant>
    LanesByType(const std::array<const Variant *, 16> &values, LaneBits lanes) {
        // Bits gathered in an array by type would wait for each other: 1 % of rendering time.
        alignas(64) std::array<int32_t, 16> index;
        index.fill(-1);
        ForEachLane(lanes, [&](int i) {
            if (values[size_t(i)]) index[size_t(i)] = int32_t(values[size_t(i)]->index());
        });
        type = IntX16::Load(index.data());
    }
    /// Lanes that hold a value.
    LaneBits All() const { return BitsOf(type >= 0); }
    /// Lanes that hold a T.
    template <typename T>
    LaneBits Of() const {
        return BitsOf(type == int32_t(Types::template kIndexOf<T>));
    }

  private:
    IntX16 type;
};

}  // namespace pbrt
