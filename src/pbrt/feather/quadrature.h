#pragma once

#include <array>
#include <concepts>

namespace pbrt::feather {

/// Nodes in (-1, 1), ascending, and weights that sum to 2.
template <std::floating_point T, int n>
struct QuadratureRule {
    std::array<T, n> node, weight;
};

/// The Gauss-Legendre rule of n points, exact for polynomials of degree 2n - 1.
/// Newton's method on the Legendre polynomial, deflated by the roots already found; in double.
template <std::floating_point T, int n>
constexpr QuadratureRule<T, n> MakeGaussLegendre() {
    QuadratureRule<T, n> rule{};
    std::array<double, n> roots{};
    for (int i = 0; i < n; ++i) {
        double x = 1, slope = 0;
        for (int step = 0; step < 60; ++step) {
            double p = 1, before = 0;
            for (int k = 0; k < n; ++k) {
                const double next = ((2 * k + 1) * x * p - k * before) / (k + 1);
                before = p;
                p = next;
            }
            slope = x * x == 1 ? n * (n + 1) / 2.0 : n * (before - x * p) / (1 - x * x);
            double deflated = slope;
            for (int j = 0; j < i; ++j)
                deflated -= p / (x - roots[j]);
            if (p == 0 || deflated == 0) break;
            x -= p / deflated;
        }
        roots[i] = x;
        rule.node[n - 1 - i] = T(x);
        rule.weight[n - 1 - i] = T(2 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

template <std::floating_point T, int n>
inline constexpr QuadratureRule<T, n> kGaussLegendre = MakeGaussLegendre<T, n>();

}  // namespace pbrt::feather
