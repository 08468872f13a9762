#include <cmath>

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/shape.h"

namespace pbrt {
namespace {

/// Half extents of the ellipse (or, with z, ellipsoid) that the unit circle (sphere) becomes.
Vector3f Reach(const Transform &t, bool withZ) {
    const Matrix4 &m = t.Matrix();
    const auto row = [&](int i) {
        return std::sqrt(Sqr(m[i][0]) + Sqr(m[i][1]) + (withZ ? Sqr(m[i][2]) : 0));
    };
    return {row(0), row(1), row(2)};
}

/// The box center +- half, widened by the rounding of a transform of points as far as `far`.
Bounds3f Around(const Transform &t, Point3f center, Vector3f half, Point3f far) {
    const Vector3f wide = half + Gamma(8) * AbsPoint(t.Matrix(), far);
    return {center - wide, center + wide};
}

/// A whole cylinder, or a disk where it has no height.
Bounds3f Tube(const Transform &t, float radius, float zMin, float zMax) {
    const Matrix4 &m = t.Matrix();
    const Vector3f along = Abs(Vector3f{m[0][2], m[1][2], m[2][2]}) * (0.5f * (zMax - zMin));
    return Around(t, t.Point({0, 0, 0.5f * (zMin + zMax)}), radius * Reach(t, false) + along,
                  {radius, radius, std::max(std::abs(zMin), std::abs(zMax))});
}

Bounds3f BoundsOf(const Sphere &s) {
    const Transform &t = s.renderFromObject;
    const float r = s.radius;
    const Bounds3f whole = Around(t, t.Point({}), r * Reach(t, true), {r, r, r});
    const Bounds3f tube = Tube(t, r, s.zMin, s.zMax);
    return {Max(whole.min, tube.min), Min(whole.max, tube.max)};
}
Bounds3f BoundsOf(const Disk &d) {
    return Tube(d.renderFromObject, d.radius, d.height, d.height);
}
Bounds3f BoundsOf(const Cylinder &c) {
    return Tube(c.renderFromObject, c.radius, c.zMin, c.zMax);
}
template <typename Mesh>
Bounds3f BoundsOf(const Mesh &mesh) {
    Bounds3f b;
    for (const uint32_t i : mesh.indices)
        b.Grow(mesh.p[i]);
    return b;
}
/// Segments lie in the hull of their points, and lines about them in the hull of the balls.
Bounds3f BoundsOf(const CurveSet &curves) {
    Bounds3f b;
    for (const CurvePoint &c : curves.points) {
        const Vector3f r{c.radius, c.radius, c.radius};
        b.Grow(c.p - r);
        b.Grow(c.p + r);
    }
    return b;
}

}  // namespace

size_t NPrimitives(const Shape &shape) {
    return std::visit([](const auto &s) { return s.NPrimitives(); }, shape);
}

Bounds3f Bounds(const Shape &shape) {
    return std::visit([](const auto &s) { return BoundsOf(s); }, shape);
}

}  // namespace pbrt
