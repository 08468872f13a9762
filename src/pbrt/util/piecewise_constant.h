#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "pbrt/util/check.h"
#include "pbrt/util/wide.h"

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
inline WideUint FindStep(const float *from, WideUint start, uint32_t size, WideFloat u) {
    WideUint step{};
    for (uint32_t stride = std::bit_floor(size); stride > 0; stride /= 2) {
        // Beyond the end lies the cdf's last value, 1: above u.
        const WideUint next = Select(step + stride < size, step + stride, WideUint{} + size);
        step = Select(Gather(from, start + next) <= u, next, step);
    }
    return step;
}

/// Where between two successive values of a cdf the number u falls, 0 to 1.
template <AnyFloat T>
inline T PlaceInStep(T low, T high, T u) {
    const T width = high - low;
    return Select(width > 0, (u - low) / width, 0.f);
}
inline float PlaceInStep(std::span<const float> cdf, int i, float u) {
    return PlaceInStep(cdf[size_t(i)], cdf[size_t(i) + 1], u);
}
inline WideFloat PlaceInStep(const float *from, WideUint at, WideFloat u) {
    return PlaceInStep(Gather(from, at), Gather(from, at + 1), u);
}

inline int StepAt(float x, int n) {
    return std::clamp(int(x * float(n)), 0, n - 1);
}
inline WideUint StepAt(WideFloat x, int n) {
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
    struct Sample {
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
    Sample Draw(float u) const {
        const int i = detail::FindStep(cdf, u);
        const float x = (float(i) + detail::PlaceInStep(cdf, i, u)) / float(Size());
        return {std::min(x, OneMinusEpsilon), density[size_t(i)], i};
    }
    /// Sixteen of Sample.
    struct Samples {
        WideFloat x;
        WideUint step;
    };
    Samples Draw(WideFloat u) const {
        const WideUint i = detail::FindStep(cdf.data(), WideUint{}, uint32_t(Size()), u);
        const WideFloat x = (ToFloat(i) + detail::PlaceInStep(cdf.data(), i, u)) / float(Size());
        return {Min(x, OneMinusEpsilon), i};
    }
    float PDF(float x) const { return density[size_t(detail::StepAt(x, Size()))]; }
    /// The u that Draw turns into x.
    float Invert(float x) const { return detail::CdfAt(cdf, x); }
    /// Of the given function over [0, 1].
    float Integral() const { return integral; }
    int Size() const { return int(density.size()); }

  private:
    std::vector<float> density, cdf;
    float integral = 0;
};

/// Density on [0, 1]^2 proportional to a step function on a grid. Immutable after construction.
class PiecewiseConstant2D {
  public:
    struct Sample {
        Point2f p;
        float pdf;
        Point2i step;  ///< column and row
    };

    PiecewiseConstant2D() = default;
    /// `f`: nu x nv values, rows of constant v one after another; finite, none negative; all 0
    /// means uniform.
    PiecewiseConstant2D(std::span<const float> f, int nu, int nv);

    /// u in [0, 1)^2; u.y picks the row.
    Sample Draw(Point2f u) const {
        const PiecewiseConstant1D::Sample row = rows.Draw(u.y);
        const std::span<const float> cdf = RowCdf(row.step);
        const int i = detail::FindStep(cdf, u.x);
        const float x = (float(i) + detail::PlaceInStep(cdf, i, u.x)) / float(nu);
        return {{std::min(x, OneMinusEpsilon), row.x}, Density(i, row.step), {i, row.step}};
    }
    /// Sixteen of Sample.
    struct Samples {
        WidePoint2f p;
        WideFloat pdf;
        WideUint column, row;
    };
    Samples Draw(WidePoint2f u) const {
        const PiecewiseConstant1D::Samples row = rows.Draw(u.y);
        const WideUint start = row.step * uint32_t(nu + 1);
        const WideUint i = detail::FindStep(cdfs.data(), start, uint32_t(nu), u.x);
        const WideFloat x =
            (ToFloat(i) + detail::PlaceInStep(cdfs.data(), start + i, u.x)) / float(nu);
        return {{Min(x, OneMinusEpsilon), row.x}, Density(i, row.step), i, row.step};
    }
    WideFloat PDF(WidePoint2f p) const {
        return Density(detail::StepAt(p.x, nu), detail::StepAt(p.y, nv));
    }
    float PDF(Point2f p) const { return Density(detail::StepAt(p.x, nu), detail::StepAt(p.y, nv)); }
    /// The u that Draw turns into p.
    Point2f Invert(Point2f p) const {
        return {detail::CdfAt(RowCdf(detail::StepAt(p.y, nv)), p.x), rows.Invert(p.y)};
    }
    /// Of the given function over [0, 1]^2.
    float Integral() const { return rows.Integral(); }
    Point2i Resolution() const { return {nu, nv}; }

  private:
    std::span<const float> RowCdf(int row) const {
        return std::span(cdfs).subspan(size_t(row) * size_t(nu + 1), size_t(nu + 1));
    }
    float Density(int column, int row) const {
        return density[size_t(row) * size_t(nu) + size_t(column)];
    }
    WideFloat Density(WideUint column, WideUint row) const {
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
