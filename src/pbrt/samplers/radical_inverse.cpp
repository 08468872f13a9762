#include "pbrt/samplers/radical_inverse.h"

#include <bit>
#include <cmath>
#include <numeric>

#include "pbrt/util/check.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

constexpr uint32_t kLargestPrime = 1619;  // its cube, like 2^24 times any below 2^8, is below 2^32

uint32_t NextPrime(uint32_t n) {
    const auto isPrime = [](uint32_t p) {
        for (uint32_t d = 3; d * d <= p; d += 2)
            if (p % d == 0) return false;
        return true;
    };
    do {
        n += 2;
    } while (!isPrime(n));
    return n;
}

/// The least number with prime^-digits <= 2^-24.
int DigitsOfAFloat(uint32_t prime) {
    int digits = 0;
    for (uint64_t power = 1; power < uint64_t(1) << 24; power *= prime)
        ++digits;
    return digits;
}

}  // namespace

OddDivisor::OddDivisor(uint32_t value)
    : value(value),
      shift(31 + int(std::bit_width(value))),
      factor((uint64_t(1) << shift) / value + 1) {
    DCHECK(value % 2 == 1 && value < 1 << 11);
}

RadicalInverses::RadicalInverses(int count, uint64_t seed) {
    Rng rng(seed);
    for (uint32_t prime = 3; int(bases.size()) < count; prime = NextPrime(prime)) {
        DCHECK(prime <= kLargestPrime);
        const int digits = DigitsOfAFloat(prime);
        bases.push_back(
            {OddDivisor(prime), digits, float(std::pow(double(prime), -digits)), images.size()});
        for (int place = 0; place < digits; ++place) {
            images.resize(images.size() + prime);
            uint32_t *permutation = &images[images.size() - prime];
            std::iota(permutation, permutation + prime, 0u);
            for (uint32_t i = prime - 1; i > 0; --i)
                std::swap(permutation[i], permutation[rng.Below(i + 1)]);
        }
    }
}

}  // namespace pbrt
