#pragma once

#include <array>

#include "pbrt/samplers/sobol_directions.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// Generator matrices of the Sobol' sequence, for indices of up to 56 bits, as tables: what four
/// digits of the index add to a number. 226 kilobytes, made once in less than a millisecond.
class SobolMatrices {
  public:
    static const SobolMatrices &Get();

    /// Number of the point low + 2^32 high, with reversed digits (sobol.h), of which 32 are exact.
    /// 2 <= dimension < kSobolDimensions; the index has up to indexBits digits, more are ignored
    /// four by four. U: uint32_t or UintX16.
    template <typename U>
    U Number(int dimension, U low, const U &high, int indexBits) const {
        const auto &nibbles = tables[size_t(dimension) - 2];
        U number{};
        for (size_t n = 0; 4 * int(n) < indexBits; ++n) {
            if (n == 8) low = high;
            number ^= Entry(nibbles[n], low);
            low = low >> 4;
        }
        return number;
    }

  private:
    static constexpr size_t kNibbles = 14;
    using Entries = std::array<uint32_t, 16>;

    SobolMatrices();

    static uint32_t Entry(const Entries &entries, uint32_t i) { return entries[i & 15]; }
    static UintX16 Entry(const Entries &entries, const UintX16 &i) {
        return Permute(LoadX16(entries.data()), i);
    }

    alignas(64) std::array<std::array<Entries, kNibbles>, size_t(kSobolDimensions) - 2> tables;
};

}  // namespace pbrt
