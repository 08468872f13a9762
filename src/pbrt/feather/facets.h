#pragma once

#include <cmath>
#include <concepts>

#include "bend.h"
#include "direction.h"
#include "row.h"

namespace pbrt::feather {

/// A facet of the bent row: the segment it lies on and its point on the cross-section's circle.
/// Each normal belongs to one facet, so what is seen of it is exact, not statistical.
template <std::floating_point T>
struct Facet {
    Segment<T> segment;
    Planar<T> point;  ///< along (cos e, sin e), not normalised
    T length;         ///< of `point`: sqrt(b^2 cos^2 phi + sin^2 phi)
    T equator;        ///< sine of the normal's angle to the x axis; 0 marks the pole
};

/// The facet with normal `m` (any length; `length` is its length). Source: MODEL sections 4.1, 5.
template <std::floating_point T>
Facet<T> FacetWithNormal(const Row<T> &row, Direction<T> m, T length) {
    constexpr T pole = sizeof(T) > sizeof(float) ? T(1e-12) : T(1e-6);
    const T yz = std::sqrt(m.y * m.y + m.z * m.z);
    if (!(yz > pole * length)) return {{0, 1}, {0, 0}, 0, 0};
    const T s = std::copysign(T(1), m.z), scale = 1 / length, across = 1 / yz;
    const Planar<T> phi = row.ToAxes(Planar<T>{s * yz * scale, m.x * scale});
    const Planar<T> point{row.Aspect() * phi.n, phi.x};
    return {{s * m.y * across, std::abs(m.z) * across},
            point,
            std::sqrt(Dot(point, point)),
            yz * scale};
}

/// The unit normal of the facet at the point e of the circle, on the given segment.
template <std::floating_point T>
Direction<T> NormalAt(const Row<T> &row, Segment<T> a, Planar<T> e) {
    const Planar<T> axes{e.n, row.Aspect() * e.x};
    const T scale = 1 / std::sqrt(Dot(axes, axes));
    const Planar<T> across = row.FromAxes({axes.n * scale, axes.x * scale});
    return {across.x, across.n * a.sin, across.n * a.cos};
}

/// Area of facets per area of vane and per solid angle of their normal, D(m) of MODEL section 5;
/// 0 at the integrable pole along x.
template <std::floating_point T>
T FacetDensity(const Row<T> &row, const Bend<T> &bend, const Facet<T> &facet) {
    if (facet.equator == 0) return 0;
    const T ratio = row.Aspect() / facet.length;
    return ratio * ratio / (facet.length * 2 * row.Spacing() * bend.SinOpening() * facet.equator);
}

/// V_w(m): whether w sees the facet.
template <std::floating_point T>
bool Sees(const Row<T> &row, const Bend<T> &bend, Direction<T> w, const Facet<T> &facet) {
    return bend.Sees(w, facet.segment) &&
           row.SeenFrom(facet.segment.Across(w)).Sees(facet.point, facet.length);
}

}  // namespace pbrt::feather
