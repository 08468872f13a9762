#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "pbrt/util/vecmath.h"

namespace pbrt::test {

/// Power sent up, by cosine of the angle with the normal, in equal steps of its square.
struct Bands {
    static constexpr int kCount = 5;
    std::array<double, kCount> power{};
    double Total() const {
        double sum = 0;
        for (double p : power)
            sum += p;
        return sum;
    }
    void Add(float cosTheta, double p) {
        power[size_t(std::min(int(Sqr(cosTheta) * kCount), kCount - 1))] += p;
    }
};

/// Calls compare(wo, n) with directions from the normal to grazing and the number of walks that the
/// tolerances of layered BxDFs are for; its two Bands agree in all and band by band.
template <typename F>
void ExpectSameBands(const std::string &name, double tolerance, const F &compare) {
    for (const Vector3f &wo : {Vector3f{0, 0, 1}, Normalize(Vector3f{0.5f, 0.6f, 0.7f}),
                               Normalize(Vector3f{-0.9f, 0.2f, 0.2f})}) {
        const auto [ours, walked] = compare(wo, 400000);
        EXPECT_NEAR(ours.Total(), walked.Total(), tolerance) << name << wo.z;
        for (size_t b = 0; b < Bands::kCount; ++b)
            EXPECT_NEAR(ours.power[b], walked.power[b], tolerance) << name << wo.z << ' ' << b;
    }
}

}  // namespace pbrt::test
