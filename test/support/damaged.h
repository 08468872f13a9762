#pragma once

#include <random>
#include <string>

namespace pbrt {

/// One to three bytes changed; in half of the cases the end is cut off as well.
inline std::string Damaged(std::string good, std::mt19937 &random) {
    for (size_t k = 1 + random() % 3; k > 0; --k)
        good[random() % good.size()] ^= char(1 + random() % 255);
    if (random() % 2) good.resize(random() % good.size());
    return good;
}

}  // namespace pbrt
