#include "pbrt/samplers/sobol_sampler.h"

#include <gtest/gtest.h>

#include "samplers/nets.h"

namespace pbrt {
namespace {

constexpr std::array kAllRandomizations{Randomization::None, Randomization::PermuteDigits,
                                        Randomization::Owen, Randomization::FastOwen};

/// Bit by bit, from the recurrence of Bratley and Fox in its usual form.
uint32_t SlowNumber(int dimension, uint64_t index) {
    const SobolDirections &d = kSobolDirections[size_t(dimension) - 2];
    const auto degree = size_t(std::bit_width(d.polynomial)) - 1;
    std::array<uint64_t, 56> v;  // fractions of 2^64
    uint64_t number = 0;
    for (size_t j = 0; j < v.size(); ++j) {
        if (j < degree) {
            v[j] = uint64_t(d.first[j]) << (63 - j);
        } else {
            // Summed up aside: g++ 14.2 for AVX-512 loses terms of v[j] ^= v[j - i].
            uint64_t sum = v[j - degree] ^ (v[j - degree] >> degree);
            for (size_t i = 1; i < degree; ++i)
                if (d.polynomial >> (degree - i) & 1) sum ^= v[j - i];
            v[j] = sum;
        }
        if (index >> j & 1) number ^= v[j];
    }
    return uint32_t(number >> 32);
}

TEST(SobolMatrices, AreThoseOfTheDirectionNumbers) {
    const SobolMatrices &matrices = SobolMatrices::Get();
    for (int dimension = 2; dimension < kSobolDimensions; ++dimension) {
        for (int bits : {5, 32, 33, 56}) {
            const uint64_t index = Hash(dimension, bits) >> (64 - bits);
            const uint32_t low = uint32_t(index), high = uint32_t(index >> 32);
            const uint32_t expected = SlowNumber(dimension, index);
            EXPECT_EQ(ReverseBits32(matrices.Number(dimension, low, high, bits)), expected);
            const UintX16 wide = matrices.Number(dimension, UintX16(low), UintX16(high), bits);
            EXPECT_EQ(ReverseBits32(wide[11]), expected);
        }
    }
}

/// The first 2^n points of each dimension lie in the 2^n intervals, one in each.
TEST(SobolMatrices, EachDimensionIsAPermutationOfTheIntervals) {
    for (int dimension = 2; dimension < kSobolDimensions; ++dimension) {
        std::vector<bool> full(1 << 10);
        for (uint32_t i = 0; i < full.size(); ++i)
            full[SobolMatrices::Get().Number(dimension, i, 0u, 10) & 1023] = true;
        EXPECT_EQ(std::count(full.begin(), full.end(), true), std::ssize(full)) << dimension;
    }
}

Point2f Film(SobolSampler &sampler, Point2i pixel, int k) {
    sampler.StartPixelSample(pixel, k, kFilmDimension);
    return sampler.Get2D();
}

/// Twelve digits, so that the place in the image is exact, too.
float Truncated(float u) {
    return std::floor(u * 4096) / 4096;
}

/// The whole square's points, in units of the square, are a net, whatever their digits in the
/// pixel.
TEST(SobolSampler, FilmIsANetOfTheWholeImage) {
    for (Randomization randomization : kAllRandomizations) {
        for (int side : {1, 2, 8, 32}) {
            for (int spp : {1, 4, 16}) {
                SobolSampler sampler(spp, {side, side - side / 4}, randomization, 3);
                std::vector<Point2f> points;
                for (int p = 0; p < side * side; ++p) {
                    for (int k = 0; k < spp; ++k) {
                        const Point2i pixel{p % side, p / side};
                        const Point2f u = Film(sampler, pixel, k);
                        points.push_back({(float(pixel.x) + Truncated(u.x)) / float(side),
                                          (float(pixel.y) + Truncated(u.y)) / float(side)});
                    }
                }
                EXPECT_TRUE(IsNet(points)) << side << " pixels a side, " << spp << " samples";
            }
        }
    }
}

/// Without randomisation sample k of a pixel is a point of run k of the sequence, whose other
/// dimensions it has.
TEST(SobolSampler, IsTheSobolSequence) {
    const int m = 3, spp = 8;
    SobolSampler sampler(spp, {8, 8}, Randomization::None, 0);
    for (uint32_t i = 0; i < uint32_t(spp) << 2 * m; ++i) {
        const uint32_t x = ReverseBits32(i), y = ReverseBits32(SobolYReversed(i));
        const Point2i pixel{int(x >> (32 - m)), int(y >> (32 - m))};
        const int k = int(i >> 2 * m);
        EXPECT_EQ(Film(sampler, pixel, k), (Point2f{ToUnitFloat(x << m), ToUnitFloat(y << m)}));
        for (int dimension : {0, 2, 50, 127}) {
            const int first = 2 * (dimension + (dimension == 0));
            sampler.StartPixelSample(pixel, k, dimension);
            EXPECT_EQ(sampler.Get2D(), (Point2f{ToUnitFloat(SlowNumber(first, i)),
                                                ToUnitFloat(SlowNumber(first + 1, i))}));
        }
    }
}

/// 2^16 pixels a side and 2^24 samples: indices of 56 bits, against the same digit by digit.
TEST(SobolSampler, LongIndices) {
    const int spp = 1 << 24;
    SobolSampler sampler(spp, {65536, 50000}, Randomization::None, 0);
    for (Point2i pixel : {Point2i{0, 0}, {65535, 49999}, {12345, 43210}}) {
        for (int k : {0, 1, 77777, spp - 1}) {
            // The upper digits of the pixel's index are k, the lower those of x, and the middle
            // ones such that the second coordinate's first digits are those of y.
            uint64_t index = uint64_t(k) << 32 | ReverseBits32(uint32_t(pixel.x) << 16);
            const auto y = [](uint64_t i) {
                return SobolYReversed(uint32_t(i) ^ uint32_t(i >> 32));
            };
            const uint32_t wanted = ReverseBits32(uint32_t(pixel.y) << 16);
            // The net's property makes the choice of the middle digits unique.
            uint32_t found = 0, hits = 0;
            for (uint32_t middle = 0; middle < 1 << 16; ++middle) {
                if ((y(index | uint64_t(middle) << 16) & 0xffff) != wanted) continue;
                found = middle, ++hits;
            }
            ASSERT_EQ(hits, 1u);
            index |= uint64_t(found) << 16;
            sampler.StartPixelSample(pixel, k, 20);
            EXPECT_EQ(sampler.Get1D(), ToUnitFloat(SlowNumber(40, index)));
        }
    }
}

/// The samples of a pixel are a net in the film's draw: they are one run's points of each square.
TEST(SobolSampler, FilmSamplesOfAPixelAreANet) {
    for (Randomization randomization : kAllRandomizations) {
        for (int spp = 4; spp <= 1024; spp *= 4) {
            SobolSampler sampler(spp, {10, 10}, randomization, 7);
            for (int p = 0; p < 100; p += 7) {
                std::vector<Point2f> points;
                for (int k = 0; k < spp; ++k)
                    points.push_back(Film(sampler, {p % 10, p / 10}, k));
                EXPECT_TRUE(IsNet(points)) << spp << " samples, pixel " << p;
            }
        }
    }
}

}  // namespace
}  // namespace pbrt
