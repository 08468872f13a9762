#include <cmath>

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/shape.h"

namespace pbrt {
namespace {

/// Bounds of the transformed box, widened by the transform's rounding.
Bounds3f Placed(const Transform &t, const Bounds3f &box) {
    Bounds3f b = t.Bounds(box);
    const Vector3f error = Gamma(6) * Max(AbsPoint(t.Matrix(), box.min),
                                          AbsPoint(t.Matrix(), box.max));
    return {b.min - error, b.max + error};
}

Bounds3f BoundsOf(const Sphere &s) {
    const float r = s.radius;
    return Placed(s.renderFromObject, {{-r, -r, s.zMin}, {r, r, s.zMax}});
}
Bounds3f BoundsOf(const Disk &d) {
    const float r = d.radius;
    return Placed(d.renderFromObject, {{-r, -r, d.height}, {r, r, d.height}});
}
Bounds3f BoundsOf(const Cylinder &c) {
    const float r = c.radius;
    return Placed(c.renderFromObject, {{-r, -r, c.zMin}, {r, r, c.zMax}});
}
template <typename Mesh>
Bounds3f BoundsOf(const Mesh &mesh) {
    Bounds3f b;
    for (const uint32_t i : mesh.indices) b.Grow(mesh.p[i]);
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
