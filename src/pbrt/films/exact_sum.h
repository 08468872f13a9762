#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pbrt {

/// Sum of numbers that does not depend on their order or grouping: a fixed-point number of 128
/// bits.
///   |x| <= 2^62, larger counts as 2^62; sums stay within +- 2^63, where those of one sign stop
/// Error: each number is rounded towards 0 to a multiple of 2^-63, nothing else is rounded. So the
/// sum of values around 1e-12, an image that is black to every format but 32-bit floats, has 7
/// digits.
class ExactSum {
  public:
    static constexpr double kLargest = 0x1p62;

    ExactSum &operator+=(double x) {
        const double size = std::min(std::abs(x), kLargest), whole = std::floor(size);
        const auto fraction = uint64_t(int64_t((size - whole) * 0x1p63)) << 1;
        const Fixed fixed = Fixed(int64_t(whole)) * (Fixed(1) << 64) + Fixed(fraction);
        Add(x < 0 ? -fixed : fixed);
        return *this;
    }
    ExactSum &operator+=(const ExactSum &b) {
        Add(b.sum);
        return *this;
    }
    double Value() const { return double(sum) * 0x1p-64; }
    bool operator==(const ExactSum &) const = default;

  private:
    __extension__ typedef __int128 Fixed;

    void Add(Fixed x) {
        __extension__ constexpr Fixed kMost = Fixed(~static_cast<unsigned __int128>(0) >> 1);
        if (__builtin_add_overflow(sum, x, &sum)) [[unlikely]]
            sum = x < 0 ? -kMost : kMost;
    }

    Fixed sum = 0;
};

}  // namespace pbrt
