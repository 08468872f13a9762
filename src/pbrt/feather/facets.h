#pragma once

#include <cmath>
#include <concepts>

#include "bend.h"
#include "direction.h"
#include "row.h"

namespace pbrt::feather {

/// A facet of the bent row: the segment it lies on and its point on the cross-section's circle.
/// Each normal belongs to one facet, so what is seen of it is exact, not statistical.
template <class V>
struct Facet {
    Segment<V> segment;
    Planar<V> point;  ///< along (cos e, sin e), not normalised
    V length;         ///< of `point`: sqrt(b^2 cos^2 phi + sin^2 phi)
    V equator;        ///< sine of the normal's angle to the x axis; 0 marks the pole
};

/// The facet with normal `m` (any length; `length` is its length). Source: MODEL sections 4.1, 5.
/// At the pole, or where `length` is 0, all but `equator` may be anything.
template <class V>
Facet<V> FacetWithNormal(const Row<V> &row, const Direction<V> &m, const V &length) {
    using T = ScalarOf<V>;
    constexpr T pole = sizeof(T) > sizeof(float) ? T(1e-12) : T(1e-6);
    const V yz = Sqrt(m.y * m.y + m.z * m.z);
    const auto known = yz > pole * length;
    if (!Any(known)) return {{V(0), V(1)}, {V(0), V(0)}, V(0), V(0)};
    const V s = SignOf(m.z), scale = 1 / length, across = 1 / yz;
    const Planar<V> phi = row.ToAxes(Planar<V>{s * yz * scale, m.x * scale});
    const Planar<V> point{row.Aspect() * phi.n, phi.x};
    return {{s * m.y * across, Abs(m.z) * across},
            point,
            Sqrt(Dot(point, point)),
            Select(known, yz * scale, V(0))};
}

/// The unit normal of the facet at the point e of the circle, on the given segment.
template <class V>
Direction<V> NormalAt(const Row<V> &row, const Segment<V> &a, const Planar<V> &e) {
    const Planar<V> axes{e.n, row.Aspect() * e.x};
    const V scale = 1 / Sqrt(Dot(axes, axes));
    const Planar<V> across = row.FromAxes({axes.n * scale, axes.x * scale});
    return {across.x, across.n * a.sin, across.n * a.cos};
}

/// Area of facets per area of vane and per solid angle of their normal, D(m) of MODEL section 5;
/// 0 at the integrable pole along x.
template <class V>
V FacetDensity(const Row<V> &row, const Bend<V> &bend, const Facet<V> &facet) {
    const V ratio = row.Aspect() / facet.length;
    const V density =
        ratio * ratio / (facet.length * 2 * row.Spacing() * bend.SinOpening() * facet.equator);
    return Select(facet.equator == 0, V(0), density);
}

/// V_w(m): whether w sees the facet.
template <class V>
MaskFor<V> Sees(const Row<V> &row, const Bend<V> &bend, const Direction<V> &w,
                const Facet<V> &facet) {
    const auto seen = bend.Sees(w, facet.segment);
    if (!Any(seen)) return seen;
    return seen & row.SeenFrom(facet.segment.Across(w)).Sees(facet.point, facet.length);
}

}  // namespace pbrt::feather
