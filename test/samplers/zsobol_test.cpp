#include "pbrt/samplers/zsobol.h"

#include <gtest/gtest.h>

#include "pbrt/samplers/independent.h"
#include "samplers/errors.h"
#include "samplers/nets.h"

namespace pbrt {
namespace {

constexpr std::array kRandomizations{Randomization::None, Randomization::PermuteDigits,
                                     Randomization::Owen, Randomization::FastOwen};

std::vector<Point2f> Points(ZSobolSampler &sampler, Point2i corner, int side, int dimension) {
    std::vector<Point2f> points;
    for (int y = corner.y; y < corner.y + side; ++y) {
        for (int x = corner.x; x < corner.x + side; ++x) {
            for (int i = 0; i < sampler.SamplesPerPixel(); ++i) {
                sampler.StartPixelSample({x, y}, i, dimension);
                points.push_back(sampler.Get2D());
            }
        }
    }
    return points;
}

TEST(ZSobolSampler, SamplesOfAPixelAreANet) {
    for (Randomization randomization : kRandomizations) {
        for (int seed : {0, 1, 5}) {
            for (int samples = 1; samples <= 1024; samples *= 4) {
                ZSobolSampler sampler(samples, {10, 10}, randomization, seed);
                for (Point2i pixel : {Point2i{0, 0}, Point2i{9, 9}, Point2i{3, 7}}) {
                    for (int dimension : {0, 1, 15, 16, 63, 64, 200})
                        EXPECT_TRUE(IsNet(Points(sampler, pixel, 1, dimension)))
                            << samples << " samples, dimension " << dimension;
                }
            }
        }
    }
}

/// Squares of 2^k pixels share a net: so no two samples share an index, and neighbours fill each
/// other's holes.
TEST(ZSobolSampler, SamplesOfAlignedSquaresAreNets) {
    for (Randomization randomization : kRandomizations) {
        for (int samples : {1, 2, 4, 8}) {
            ZSobolSampler sampler(samples, {100, 30}, randomization, 7);
            for (int side : {2, 4, 8, 16}) {
                for (int dimension : {0, 3, 17, 70})
                    EXPECT_TRUE(IsNet(Points(sampler, {48, 16}, side, dimension)))
                        << samples << " samples, side " << side;
            }
        }
    }
}

/// The whole picture: at 2^16 pixels a side and 2^10 samples the index has 42 bits.
TEST(ZSobolSampler, LongIndicesKeepTheNets) {
    ZSobolSampler sampler(1024, {65536, 65536}, Randomization::FastOwen, 1);
    EXPECT_TRUE(IsNet(Points(sampler, {65535, 65535}, 1, 4)));
    ZSobolSampler coarse(16, {65536, 65536}, Randomization::FastOwen, 1);
    EXPECT_TRUE(IsNet(Points(coarse, {40000, 60000}, 8, 4)));
}

/// Nets integrate n points of an edge with variance n^-3/2, smooth functions with n^-3. So among
/// 16 pixels of the tree white noise is reduced to about 16^-1/2 = 0.25 or less, and among 4,
/// which is what blocks that do not fit the tree have, to about 0.5 or less.
TEST(ZSobolSampler, ErrorIsBlueNoise) {
    const int side = 128;
    for (int dimension : {0, 5, 20}) {
        for (int samples : {1, 4, 16}) {
            const ZSobolSampler sampler(samples, {side, side}, Randomization::FastOwen, 2);
            const auto smooth = Errors(sampler, side, dimension, Smooth);
            EXPECT_LT(LowFrequencies(smooth, side, {0, 0}), 0.1) << samples << " samples";
            EXPECT_LT(LowFrequencies(smooth, side, {2, 2}), 0.5) << samples << " samples";
            const auto edge = Errors(sampler, side, dimension, Edge);
            EXPECT_LT(LowFrequencies(edge, side, {0, 0}), 0.5) << samples << " samples";
            EXPECT_LT(LowFrequencies(edge, side, {2, 2}), 0.8) << samples << " samples";
        }
    }
    for (auto *f : {Smooth, Edge}) {
        const auto white = Errors(IndependentSampler(4, 2), side, 0, f);
        EXPECT_NEAR(LowFrequencies(white, side, {0, 0}), 1, 0.2);
    }
}

}  // namespace
}  // namespace pbrt
