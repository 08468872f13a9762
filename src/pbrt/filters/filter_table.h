#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "pbrt/util/check.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// A sample of one axis of a separable filter: offset in pixels and f / pdf.
struct AxisSample {
    float x, weight;
};

/// Samples an even function f on [-radius, radius] with density proportional to |g|, where g
/// interpolates f linearly over so many steps (128 to 4096) that |g - f| stays below 3e-4 of f(0);
/// f may change sign. The weight is g / pdf, so it has constant magnitude. Monotonic in u.
class FilterTable {
  public:
    template <typename F>
    FilterTable(const F &f, float radius) {
        int steps = 128;
        while (steps < 4096 && InterpolationError(f, radius, steps) > 3e-4f * f(0))
            steps *= 2;
        Build(KnotsOf(f, radius, steps));
    }

    /// u in [0, 1).
    AxisSample Sample(float u) const {
        const float v = 2 * u - 1, place = std::min(std::abs(v), OneMinusEpsilon);
        size_t i = guide[size_t(place * kGuide)];
        while (place >= cells[i + 1].start)
            ++i;
        const Cell &c = cells[i];
        const float w = (place - c.start) * c.inverseMass;
        // Inverse of the quadratic a t + (b - a) t^2 / 2 = w (a + b) / 2, without cancellation.
        const float root = c.a + std::sqrt(std::max(0.f, c.a * c.a + w * c.squares));
        const float x = c.x0 + w * c.span / std::max(root, 1e-20f);
        return {std::copysign(x, v), c.weight};
    }

  private:
    static constexpr int kGuide = 256;
    /// A step of [0, radius] in which g does not change sign, from value a to b.
    struct Cell {
        float start, inverseMass;  ///< of the cumulated |g|, which is 1 at the radius
        float x0, span;            ///< width (|a| + |b|)
        float a, squares;          ///< |a|, b^2 - a^2
        float weight;
    };
    struct Knot {
        double x, f;
    };

    template <typename F>
    static float InterpolationError(const F &f, float radius, int steps) {
        float worst = 0;
        const float h = radius / float(steps);
        for (int i = 0; i < steps; ++i) {
            const float a = f(h * float(i)), b = f(h * float(i + 1));
            worst = std::max(worst, std::abs((a + b) / 2 - f(h * (float(i) + 0.5f))));
        }
        return worst;
    }
    template <typename F>
    static std::vector<Knot> KnotsOf(const F &f, float radius, int steps) {
        std::vector<Knot> knots;
        for (int i = 0; i <= steps; ++i) {
            const float x = radius * float(i) / float(steps);
            const Knot next{x, f(x)};
            if (i > 0 && knots.back().f * next.f < 0) {
                const Knot last = knots.back();
                knots.push_back({last.x + (next.x - last.x) * last.f / (last.f - next.f), 0});
            }
            knots.push_back(next);
        }
        return knots;
    }
    void Build(const std::vector<Knot> &knots);

    std::vector<Cell> cells;  ///< of positive mass; at the end a sentinel that starts at 1
    std::array<uint16_t, kGuide> guide;
};

inline void FilterTable::Build(const std::vector<Knot> &knots) {
    const auto mass = [&](size_t i) {
        return (knots[i + 1].x - knots[i].x) * std::abs(knots[i].f + knots[i + 1].f) / 2;
    };
    double half = 0;
    for (size_t i = 0; i + 1 < knots.size(); ++i)
        half += mass(i);
    DCHECK(half > 0);
    double sum = 0;
    for (size_t i = 0; i + 1 < knots.size(); ++i) {
        const double a = std::abs(knots[i].f), b = std::abs(knots[i + 1].f), m = mass(i);
        if (m == 0) continue;
        const double sign = knots[i].f + knots[i + 1].f < 0 ? -1 : 1;
        cells.push_back({float(sum / half), float(half / m), float(knots[i].x),
                         float((knots[i + 1].x - knots[i].x) * (a + b)), float(a),
                         float(b * b - a * a), float(sign * 2 * half)});
        sum += m;
    }
    cells.push_back({1, 0, 0, 0, 0, 0, 0});
    size_t i = 0;
    for (int k = 0; k < kGuide; ++k) {
        while (float(k) / kGuide >= cells[i + 1].start)
            ++i;
        guide[size_t(k)] = uint16_t(i);
    }
}

}  // namespace pbrt
