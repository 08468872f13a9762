#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace pbrt::oracle {

/// A mean and its standard error.
struct Estimate {
    double mean = 0, error = 0;
    friend Estimate operator+(Estimate a, Estimate b) {
        return {a.mean + b.mean, std::hypot(a.error, b.error)};
    }
};

/// How often an estimate is made anew, with other random numbers: its error comes from the scatter.
inline constexpr int kReplicates = 64;

/// Points of the unit cube that fill it evenly: multiples of the powers of a generalised golden
/// ratio, moved by a random shift. A mean over n of them is unbiased for every n.
template <int D>
class EvenPoints {
  public:
    explicit EvenPoints(std::mt19937_64 &random) {
        double ratio = 2;  // the root of ratio^(D + 1) = ratio + 1
        for (int i = 0; i < 60; ++i)
            ratio = std::pow(ratio + 1, 1.0 / (D + 1));
        for (int j = 0; j < D; ++j) {
            step[j] = std::pow(ratio, -(j + 1));
            at[j] = std::generate_canonical<double, 53>(random);
        }
    }
    std::array<double, D> Next() {
        for (int j = 0; j < D; ++j) {
            at[j] += step[j];
            at[j] -= std::floor(at[j]);
        }
        return at;
    }

  private:
    std::array<double, D> step, at;
};

/// Means of several quantities from kReplicates independent replicates.
class Replicates {
  public:
    explicit Replicates(std::size_t quantities)
        : now(quantities), sum(quantities), square(quantities), weight(quantities) {}

    void Add(std::size_t quantity, double x) {
        now[quantity] += x;
        weight[quantity] += x * x;
    }

    /// A replicate is complete; its quantities are divided by `samples`.
    void Close(double samples) {
        for (std::size_t i = 0; i < now.size(); ++i) {
            const double mean = now[i] / samples;
            sum[i] += mean;
            square[i] += mean * mean;
            now[i] = 0;
        }
        all += samples;
    }

    /// Where a handful of samples makes up the whole, their scatter says too little: three of them
    /// more or less are allowed for.
    Estimate operator[](std::size_t i) const {
        const double n = kReplicates, mean = sum[i] / n;
        const double variance = std::max(0.0, square[i] / n - mean * mean) / (n - 1);
        const double one = mean == 0 ? 0 : weight[i] / (mean * all);  // a typical sample
        return {mean, std::hypot(std::sqrt(variance), 3 * one / all)};
    }

    std::vector<Estimate> Part(std::size_t from, std::size_t n) const {
        std::vector<Estimate> part;
        for (std::size_t i = from; i < from + n; ++i)
            part.push_back((*this)[i]);
        return part;
    }

  private:
    std::vector<double> now, sum, square, weight;
    double all = 0;
};

/// Two-sided quantile of Student's t: P(|t| > result) = p, by bisection of an integral.
inline double StudentQuantile(double p, int degrees) {
    const auto tail =
        [&](double t) {  // with t = sqrt(degrees) tan(x) the density is cos^(degrees-1)
            const double x = std::atan(t / std::sqrt(double(degrees)));
            const int n = 2000;
            double part = 0, all = 0;
            for (int i = 0; i < n; ++i) {
                part +=
                    std::pow(std::cos(x + (std::numbers::pi / 2 - x) * (i + 0.5) / n), degrees - 1);
                all += std::pow(std::cos(std::numbers::pi / 2 * (i + 0.5) / n), degrees - 1);
            }
            return part * (std::numbers::pi / 2 - x) / (all * std::numbers::pi / 2);
        };
    double lo = 0, hi = 100;
    for (int i = 0; i < 60; ++i)
        (tail((lo + hi) / 2) > p ? lo : hi) = (lo + hi) / 2;
    return (lo + hi) / 2;
}

/// Significance: the suite makes fewer than 25 000 statistical comparisons, each of which may fail
/// by chance with probability 0.01 / 25 000 (Bonferroni), so that all of them pass with 0.99.
/// In standard errors; the estimates have kReplicates - 1 degrees of freedom.
inline double CriticalSigmas() {
    static const double sigmas = StudentQuantile(0.01 / 25000, kReplicates - 1);
    return sigmas;
}

/// Difference of two independent estimates in standard errors; rounding, 1e-12, is allowed for.
inline double Sigmas(Estimate a, Estimate b) {
    return (a.mean - b.mean) / std::hypot(a.error, b.error, 1e-12);
}

inline void ExpectSame(Estimate a, Estimate b, const std::string &what) {
    EXPECT_LE(std::abs(Sigmas(a, b)), CriticalSigmas())
        << what << ": " << a.mean << " +- " << a.error << " against " << b.mean << " +- "
        << b.error;
}

}  // namespace pbrt::oracle
