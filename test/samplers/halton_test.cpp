#include "pbrt/samplers/halton.h"

#include <gtest/gtest.h>

#include <set>

namespace pbrt {
namespace {

constexpr std::array kAllRandomizations{HaltonRandomization::PermuteDigits,
                                        HaltonRandomization::None, HaltonRandomization::Owen};

double SlowInverse(uint64_t i, uint64_t base) {
    double inverse = 0;
    for (double place = 1.0 / double(base); i != 0; i /= base, place /= double(base))
        inverse += double(i % base) * place;
    return inverse;
}

TEST(OddDivisor, IsExact) {
    for (uint32_t value = 1; value < 1 << 11; value += 2) {
        const OddDivisor divisor(value);
        const uint32_t largest = (uint32_t(1) << 31) - 1;
        for (uint32_t q : {0u, 1u, 2u, largest / value / 3, largest / value - 1, largest / value}) {
            for (uint64_t i : {uint64_t(q) * value, uint64_t(q) * value + value - 1}) {
                if (i > largest) continue;
                EXPECT_EQ(divisor.Quotient(uint32_t(i)), q) << i << " / " << value;
                EXPECT_EQ(divisor.Remainder(uint32_t(i)), i - uint64_t(q) * value);
                EXPECT_EQ(divisor.Quotient(UintX16(uint32_t(i)))[3], q);
            }
        }
    }
}

/// Without randomisation the numbers are a point of the sequence: film and other draws of one index
/// which is found from the film's digits by trying all. 3 roundings of 2^-24.
TEST(HaltonSampler, IsTheHaltonSequence) {
    const int spp = 3;
    HaltonSampler sampler(spp, {10, 7}, HaltonRandomization::None, 0);
    const uint32_t columns = 16, rows = 9;
    std::set<uint64_t> indices;
    for (int p = 0; p < 70; ++p) {
        for (int k = 0; k < spp; ++k) {
            const Point2i pixel{p % 10, p / 10};
            uint64_t index = uint64_t(k) * columns * rows;
            const auto isInPixel = [&](uint64_t i) {
                return int(SlowInverse(i, 2) * columns) == pixel.x &&
                       int(SlowInverse(i, 3) * rows + 1e-9) == pixel.y;
            };
            while (!isInPixel(index))
                ++index;
            EXPECT_LT(index, uint64_t(k + 1) * columns * rows);
            indices.insert(index);
            const auto expect = [&](Point2f u, double x, double y) {
                EXPECT_NEAR(u.x, x, 3 * 0x1p-24);
                EXPECT_NEAR(u.y, y, 3 * 0x1p-24);
            };
            sampler.StartPixelSample(pixel, k, 0);
            expect(sampler.Get2D(), SlowInverse(index, 5), SlowInverse(index, 7));
            expect(sampler.Get2D(), SlowInverse(index / columns, 2), SlowInverse(index / rows, 3));
            expect(sampler.Get2D(), SlowInverse(index, 11), SlowInverse(index, 13));
            sampler.StartPixelSample(pixel, k, 127);
            expect(sampler.Get2D(), SlowInverse(index, 1613), SlowInverse(index, 1619));
        }
    }
    EXPECT_EQ(indices.size(), 70u * spp);
}

/// Boxes of the image, 2^-a wide and 3^-b high, hold one each of the first 2^a 3^b points, here all
/// of them: 2^a = columns 2^s and 3^b = rows 3^t for 2^s 3^t samples per pixel.
TEST(HaltonSampler, ElementaryIntervals) {
    const int columns = 8, rows = 9;
    for (HaltonRandomization randomization : kAllRandomizations) {
        for (auto [s, t] : {std::pair{0, 0}, {1, 1}, {3, 0}, {2, 2}, {0, 3}}) {
            const int xs = 1 << s, ys = int(std::lround(std::pow(3, t))), spp = xs * ys;
            HaltonSampler sampler(spp, {columns, rows}, randomization, 5);
            std::vector<int> boxes(size_t(columns * rows * spp));
            for (int p = 0; p < columns * rows; ++p) {
                for (int k = 0; k < spp; ++k) {
                    sampler.StartPixelSample({p % columns, p / columns}, k, kFilmDimension);
                    const Point2f u = sampler.Get2D();
                    // Boundaries of thirds are no floats: points on them are rounded to either
                    // side.
                    const int x = p % columns * xs + int(u.x * float(xs));
                    const int y = p / columns * ys + int((u.y + 1e-6f) * float(ys));
                    ++boxes[size_t(y * columns * xs + x)];
                }
            }
            EXPECT_EQ(std::count(boxes.begin(), boxes.end(), 1), std::ssize(boxes)) << spp;
        }
    }
}

/// In each dimension as many successive points as its base lie in as many intervals, one in each,
/// and so do its squares.
TEST(HaltonSampler, EachDimensionIsStratified) {
    for (HaltonRandomization randomization : kAllRandomizations) {
        HaltonSampler sampler(17 * 17, {1, 1}, randomization, 9);
        for (int intervals : {17, 17 * 17}) {
            std::vector<int> counts(static_cast<size_t>(intervals));
            for (int k = 0; k < intervals; ++k) {
                sampler.StartPixelSample({0, 0}, k, 3);
                ++counts[size_t((sampler.Get1D() + 1e-6f) * float(intervals))];
            }
            EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), intervals);
        }
    }
}

}  // namespace
}  // namespace pbrt
