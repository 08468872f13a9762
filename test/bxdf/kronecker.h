#pragma once

#include <cmath>

#include "pbrt/util/math.h"

namespace pbrt::test {

/// Five evenly spread numbers per index: multiples of powers of the plastic-like root of
/// x^6 = x + 1 (Roberts 2018).
struct Kronecker {
    double u[5];
    explicit Kronecker(int i) {
        double step = 1;
        for (double &x : u) {
            step /= 1.1347241384015194;
            x = std::fmod(0.5 + (i + 1) * step, 1.0);
        }
    }
    float operator[](int k) const { return std::min(float(u[k]), OneMinusEpsilon); }
};

}  // namespace pbrt::test
