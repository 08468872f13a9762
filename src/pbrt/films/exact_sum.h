#pragma once

#include <algorithm>
#include <array>
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

    /// The number in pieces of 32 bits, the lowest first: for files.
    std::array<uint32_t, 4> Words() const {
        std::array<uint32_t, 4> words;
        for (size_t i = 0; i < words.size(); ++i)
            words[i] = uint32_t(Bits(sum) >> (32 * i));
        return words;
    }
    static ExactSum FromWords(const uint32_t *words) {
        Bits bits = 0;
        for (size_t i = 0; i < 4; ++i)
            bits |= Bits(words[i]) << (32 * i);
        ExactSum s;
        s.sum = Fixed(bits);
        return s;
    }

  private:
    __extension__ typedef __int128 Fixed;
    __extension__ typedef unsigned __int128 Bits;

    void Add(Fixed x) {
        constexpr Fixed kMost = Fixed(~Bits(0) >> 1);
        if (__builtin_add_overflow(sum, x, &sum)) [[unlikely]]
            sum = x < 0 ? -kMost : kMost;
    }

    Fixed sum = 0;
};

}  // namespace pbrt
