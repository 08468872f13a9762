#pragma once

#include <gtest/gtest.h>

#include "pbrt/lights/light_tree.h"

namespace pbrt::test {

/// Sixteen draws of `lights` (a sampler or a tree) are, bit by bit, those of one receiver each.
template <typename Lights>
void ExpectAsEachAlone(const Lights &lights, const LightSampleContextX16 &ctx, const FloatX16 &u,
                       LaneBits lanes) {
    const SampledLights drawn = lights.Sample(ctx, u, lanes);
    ASSERT_EQ(drawn.valid & ~lanes, 0u);
    ForEachLane(lanes, [&](int i) {
        const auto one = lights.Sample(ctx.At(i), u[i]);
        ASSERT_EQ(drawn.valid >> i & 1, LaneBits(one.has_value()));
        if (!one) return;
        EXPECT_EQ(drawn.light[size_t(i)], one->light);
        EXPECT_EQ(drawn.pmf[i], one->pmf);
    });
}

}  // namespace pbrt::test
