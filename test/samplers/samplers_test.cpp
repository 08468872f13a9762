#include "pbrt/samplers/samplers.h"

#include <gtest/gtest.h>

#include "samplers/sampler_examples.h"

namespace pbrt {
namespace {

constexpr Point2i kResolution{100, 101};

std::vector<Sampler> AllSamplers(int seed) {
    std::vector<Sampler> samplers{StratifiedSampler(1, 1, true, seed),
                                  ZSobolSampler(16, kResolution, Randomization::FastOwen, seed)};
    for (const Sampler &example : SamplerExamples(kResolution, seed))
        samplers.push_back(example);
    return samplers;
}

std::vector<float> Draws(Sampler &sampler, Point2i pixel, int index) {
    return std::visit(
        [&](auto &s) {
            s.StartPixelSample(pixel, index);
            std::vector<float> draws;
            for (int i = 0; i < 90; ++i) {
                if (i % 3 == 0) {
                    draws.push_back(s.Get1D());
                } else {
                    const Point2f p = s.Get2D();
                    draws.insert(draws.end(), {p.x, p.y});
                }
            }
            return draws;
        },
        sampler);
}

TEST(Sampler, SameNumbersInAnyOrderAndFromACopy) {
    for (Sampler sampler : AllSamplers(3)) {
        const Sampler fresh = sampler;
        const int n = SamplesPerPixel(sampler);
        std::vector<std::vector<float>> inOrder;
        for (int p = 0; p < 6; ++p) {
            for (int i = 0; i < n; ++i)
                inOrder.push_back(Draws(sampler, {17 * p, 99 - 13 * p}, i));
        }
        for (int k = int(inOrder.size()) - 1; k >= 0; --k) {
            Sampler copy = k % 2 ? fresh : sampler;
            const int p = k / n;
            EXPECT_EQ(Draws(copy, {17 * p, 99 - 13 * p}, k % n), inOrder[size_t(k)]);
        }
    }
}

TEST(Sampler, StartsAtAnyDimension) {
    for (Sampler sampler : AllSamplers(4)) {
        std::visit(
            [](auto &s) {
                s.StartPixelSample({5, 6}, 0);
                std::vector<Point2f> draws;
                for (int i = 0; i < 80; ++i)
                    draws.push_back(s.Get2D());
                for (int i = 0; i < 80; i += 7) {
                    s.StartPixelSample({5, 6}, 0, i);
                    EXPECT_EQ(s.Get2D(), draws[size_t(i)]);
                }
            },
            sampler);
    }
}

TEST(Sampler, NumbersLieInTheHalfOpenInterval) {
    for (Sampler sampler : AllSamplers(5)) {
        for (int p = 0; p < 100; ++p) {
            for (float u : Draws(sampler, {p, 100 - p}, p % SamplesPerPixel(sampler)))
                ASSERT_TRUE(u >= 0 && u < 1);
        }
    }
}

/// Chi-square of 8 x 8 bins over many pixels: pairs within a draw, and across draws.
/// Bound: mean + 5 standard deviations of 63 degrees of freedom. Nets fill bins more evenly than
/// chance, so only the upper side counts.
TEST(Sampler, PairsAreUniformWithinAndAcrossDimensions) {
    const double bound = 63 + 5 * std::sqrt(2 * 63.0);
    for (Sampler sampler : AllSamplers(6)) {
        const std::vector<std::pair<int, int>> places{{1, 2}, {0, 5}, {2, 90}, {60, 61}, {4, 149}};
        std::vector<std::array<int, 64>> counts(places.size());
        // All samples of as many pixels as give 10000.
        const int spp = SamplesPerPixel(sampler), n = 10000 / spp * spp;
        for (int i = 0; i < n; ++i) {
            const Point2i pixel{i / spp % 100, i / spp / 100};
            const std::vector<float> u = Draws(sampler, pixel, i % spp);
            for (size_t k = 0; k < places.size(); ++k) {
                const float a = u[size_t(places[k].first)], b = u[size_t(places[k].second)];
                ++counts[k][size_t(a * 8) * 8 + size_t(b * 8)];
            }
        }
        for (const auto &bins : counts) {
            double chi2 = 0;
            for (int c : bins)
                chi2 += Sqr(c - n / 64.0) / (n / 64.0);
            EXPECT_LT(chi2, bound)
                << "sampler " << sampler.index() << " place " << (&bins - counts.data());
        }
    }
}

TEST(Sampler, SeedsDiffer) {
    const std::vector<Sampler> a = AllSamplers(0), b = AllSamplers(1);
    for (size_t i = 0; i < a.size(); ++i) {
        Sampler first = a[i], second = b[i];
        EXPECT_NE(Draws(first, {4, 4}, 0), Draws(second, {4, 4}, 0));
    }
}

TEST(StratifiedSampler, OneSamplePerCellAndInterval) {
    for (const auto &[nx, ny] : {std::pair{4, 4}, {5, 3}, {1, 7}, {32, 32}}) {
        StratifiedSampler sampler(nx, ny, true, 9);
        const int n = nx * ny;
        for (int dimension : {0, 1, 30}) {
            std::vector<bool> cells(static_cast<size_t>(n)), intervals(static_cast<size_t>(n));
            for (int i = 0; i < n; ++i) {
                sampler.StartPixelSample({3, 4}, i, dimension);
                const Point2f p = sampler.Get2D();
                cells[size_t(p.y * float(ny)) * size_t(nx) + size_t(p.x * float(nx))] = true;
                sampler.StartPixelSample({3, 4}, i, dimension);
                intervals[size_t(sampler.Get1D() * float(n))] = true;
            }
            EXPECT_EQ(std::count(cells.begin(), cells.end(), true), n);
            EXPECT_EQ(std::count(intervals.begin(), intervals.end(), true), n);
        }
    }
}

TEST(StratifiedSampler, WithoutJitterTheMiddles) {
    StratifiedSampler sampler(2, 1, false, 0);
    for (int i = 0; i < 2; ++i) {
        sampler.StartPixelSample({0, 0}, i);
        const Point2f p = sampler.Get2D();
        EXPECT_TRUE(p.x == 0.25f || p.x == 0.75f);
        EXPECT_EQ(p.y, 0.5f);
    }
}

}  // namespace
}  // namespace pbrt
