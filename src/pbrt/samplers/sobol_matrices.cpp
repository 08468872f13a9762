#include "pbrt/samplers/sobol_matrices.h"

#include <bit>

#include "pbrt/util/math.h"

namespace pbrt {
namespace {

constexpr size_t kColumns = 56;

/// Column j of the matrix: the number of point 2^j. Its recurrence by the primitive polynomial
/// (Bratley and Fox 1988, Algorithm 659) with all digits reversed, so what they divide by a power
/// of two is multiplied here, and digits beyond 32 fall away.
std::array<uint32_t, kColumns> Columns(const SobolDirections &d) {
    const auto degree = size_t(std::bit_width(d.polynomial)) - 1;
    std::array<uint32_t, kColumns> columns{};
    for (size_t j = 0; j < kColumns; ++j) {
        if (j < degree) {
            columns[j] = ReverseBits32(uint32_t(d.first[j])) >> (31 - j);
            continue;
        }
        // Summed up aside: g++ 14.2 for AVX-512 loses terms of columns[j] ^= columns[j - back].
        uint32_t sum = columns[j - degree] ^ (columns[j - degree] << degree);
        for (size_t back = 1; back < degree; ++back)
            if (d.polynomial >> (degree - back) & 1) sum ^= columns[j - back];
        columns[j] = sum;
    }
    return columns;
}

}  // namespace

const SobolMatrices &SobolMatrices::Get() {
    static const SobolMatrices matrices;
    return matrices;
}

SobolMatrices::SobolMatrices() {
    for (size_t d = 0; d < tables.size(); ++d) {
        const auto columns = Columns(kSobolDirections[d]);
        for (size_t n = 0; n < kNibbles; ++n) {
            Entries &entries = tables[d][n];
            entries[0] = 0;
            for (size_t i = 1; i < entries.size(); ++i) {
                const auto lowest = size_t(std::countr_zero(i));
                entries[i] = entries[i & (i - 1)] ^ columns[4 * n + lowest];
            }
        }
    }
}

}  // namespace pbrt
