#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "pbrt/util/check.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

namespace detail {

/// Fills `cdf` (n + 1 values from 0 to exactly 1) from n values of a step function on [0, 1] and
/// returns the function's integral; where that is 0 the distribution is uniform.
inline double FillCdf(std::span<const float> f, std::span<float> cdf) {
    double sum = 0;
    for (float v : f) {
        DCHECK(v >= 0 && v < Infinity);
        sum += v;
    }
    double running = 0;
    for (size_t i = 0; i < f.size(); ++i) {
        cdf[i] = float(sum > 0 ? running / sum : double(i) / double(f.size()));
        running += f[i];
    }
    // Both sums are made in the same order, so empty steps at the end have no width either.
    cdf[f.size()] = 1;
    return sum / double(f.size());
}

/// The step i with cdf[i] <= u < cdf[i + 1], u in [0, 1); it has positive width.
inline int FindStep(std::span<const float> cdf, float u) {
    const auto above = std::upper_bound(cdf.begin(), cdf.end(), u);
    return std::clamp(int(above - cdf.begin()) - 1, 0, int(cdf.size()) - 2);
}

/// The same in cdfs of `size` steps that start at from[start].
inline UintX16 FindStep(const float *from, UintX16 start, uint32_t size, FloatX16 u) {
    UintX16 step{};
    for (uint32_t stride = std::bit_floor(size); stride > 0; stride /= 2) {
        // Beyond the end lies the cdf's last value, 1: above u.
        const UintX16 next = Select(step + stride < size, step + stride, UintX16{} + size);
        step = Select(Gather(from, start + next) <= u, next, step);
    }
    return step;
}

/// Relative position of the number u between two successive values of a cdf, 0 to 1.
template <AnyFloat T>
inline T PlaceInStep(T low, T high, T u) {
    const T width = high - low;
    return Select(width > 0, (u - low) / width, 0.f);
}
inline float PlaceInStep(std::span<const float> cdf, int i, float u) {
    return PlaceInStep(cdf[size_t(i)], cdf[size_t(i) + 1], u);
}
inline FloatX16 PlaceInStep(const float *from, UintX16 at, FloatX16 u) {
    return PlaceInStep(Gather(from, at), Gather(from, at + 1), u);
}

inline int StepAt(float x, int n) {
    return std::clamp(int(x * float(n)), 0, n - 1);
}
inline UintX16 StepAt(FloatX16 x, int n) {
    return Truncate(Clamp(x * float(n), 0.f, float(n - 1)));
}

/// The cdf at x in [0, 1].
inline float CdfAt(std::span<const float> cdf, float x) {
    const int n = int(cdf.size()) - 1, i = StepAt(x, n);
    return Lerp(x * float(n) - float(i), cdf[size_t(i)], cdf[size_t(i) + 1]);
}

}  // namespace detail

/// Density on [0, 1] proportional to a step function. Immutable after construction.
class PiecewiseConstant1D {
  public:
    struct PointSample {
        float x, pdf;
        int step;
    };

    PiecewiseConstant1D() = default;
    /// `f`: at least one value, finite, none negative; all 0 means uniform.
    explicit PiecewiseConstant1D(std::span<const float> f)
        : density(f.begin(), f.end()), cdf(f.size() + 1) {
        integral = float(detail::FillCdf(f, cdf));
        for (float &d : density)
            d = integral > 0 ? d / integral : 1;
    }

    /// u in [0, 1); monotonic in u.
    PointSample Sample(float u) const {
        const int i = detail::FindStep(cdf, u);
        const float x = (float(i) + detail::PlaceInStep(cdf, i, u)) / float(Size());
        return {std::min(x, OneMinusEpsilon), density[size_t(i)], i};
    }
    /// Sixteen of Sample.
    struct PointSampleX16 {
        FloatX16 x;
        UintX16 step;
    };
    PointSampleX16 Sample(FloatX16 u) const {
        const UintX16 i = detail::FindStep(cdf.data(), UintX16{}, uint32_t(Size()), u);
        const FloatX16 x = (ToFloat(i) + detail::PlaceInStep(cdf.data(), i, u)) / float(Size());
        return {Min(x, OneMinusEpsilon), i};
    }
    float PDF(float x) const { return density[size_t(detail::StepAt(x, Size()))]; }
    /// The u that Sample turns into x.
    float Invert(float x) const { return detail::CdfAt(cdf, x); }
    /// Integral of the given function over [0, 1].
    float Integral() const { return integral; }
    int Size() const { return int(density.size()); }

  private:
    std::vector<float> density, cdf;
    float integral = 0;
};

/// Density on [0, 1]^2 proportional to a step function on a grid. Immutable after construction.
class PiecewiseConstant2D {
  public:
    struct PointSample {
        Point2f p;
        float pdf;
        Point2i step;  ///< column and row
    };

    PiecewiseConstant2D() = default;
    /// `f`: nu x nv values, rows of constant v one after another; finite, none negative; all 0
    /// means uniform.
    PiecewiseConstant2D(std::span<const float> f, int nu, int nv);

    /// u in [0, 1)^2; u.y picks the row.
    PointSample Sample(Point2f u) const {
        const PiecewiseConstant1D::PointSample row = rows.Sample(u.y);
        const std::span<const float> cdf = RowCdf(row.step);
        const int i = detail::FindStep(cdf, u.x);
        const float x = (float(i) + detail::PlaceInStep(cdf, i, u.x)) / float(nu);
        return {{std::min(x, OneMinusEpsilon), row.x}, CellPDF(i, row.step), {i, row.step}};
    }
    /// Sixteen of Sample.
    struct PointSampleX16 {
        Point2fX16 p;
        FloatX16 pdf;
        UintX16 column, row;
    };
    PointSampleX16 Sample(Point2fX16 u) const {
        const PiecewiseConstant1D::PointSampleX16 row = rows.Sample(u.y);
        const UintX16 start = row.step * uint32_t(nu + 1);
        const UintX16 i = detail::FindStep(cdfs.data(), start, uint32_t(nu), u.x);
        const FloatX16 x =
            (ToFloat(i) + detail::PlaceInStep(cdfs.data(), start + i, u.x)) / float(nu);
        return {{Min(x, OneMinusEpsilon), row.x}, CellPDF(i, row.step), i, row.step};
    }
    FloatX16 PDF(Point2fX16 p) const {
        return CellPDF(detail::StepAt(p.x, nu), detail::StepAt(p.y, nv));
    }
    float PDF(Point2f p) const { return CellPDF(detail::StepAt(p.x, nu), detail::StepAt(p.y, nv)); }
    /// The u that Sample turns into p.
    Point2f Invert(Point2f p) const {
        return {detail::CdfAt(RowCdf(detail::StepAt(p.y, nv)), p.x), rows.Invert(p.y)};
    }
    /// Integral of the given function over [0, 1]^2.
    float Integral() const { return rows.Integral(); }
    Point2i Resolution() const { return {nu, nv}; }

  private:
    std::span<const float> RowCdf(int row) const {
        return std::span(cdfs).subspan(size_t(row) * size_t(nu + 1), size_t(nu + 1));
    }
    float CellPDF(int column, int row) const {
        return density[size_t(row) * size_t(nu) + size_t(column)];
    }
    FloatX16 CellPDF(UintX16 column, UintX16 row) const {
        return Gather(density.data(), row * uint32_t(nu) + column);
    }

    int nu = 0, nv = 0;
    std::vector<float> density;  ///< per unit area
    std::vector<float> cdfs;     ///< nu + 1 values per row
    PiecewiseConstant1D rows;
};

inline PiecewiseConstant2D::PiecewiseConstant2D(std::span<const float> f, int nu, int nv)
    : nu(nu), nv(nv), density(f.begin(), f.end()), cdfs(size_t(nu + 1) * size_t(nv)) {
    DCHECK(nu > 0 && nv > 0 && f.size() == size_t(nu) * size_t(nv));
    std::vector<float> rowIntegrals(static_cast<size_t>(nv));
    for (int v = 0; v < nv; ++v) {
        const size_t row = size_t(v);
        rowIntegrals[row] =
            float(detail::FillCdf(f.subspan(row * size_t(nu), size_t(nu)),
                                  std::span(cdfs).subspan(row * size_t(nu + 1), size_t(nu + 1))));
    }
    rows = PiecewiseConstant1D(rowIntegrals);
    const float integral = rows.Integral();
    for (float &d : density)
        d = integral > 0 ? d / integral : 1;
}

}  // namespace pbrt
