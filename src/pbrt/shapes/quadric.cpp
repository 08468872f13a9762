#include "pbrt/shapes/quadric.h"

namespace pbrt {

Vector3f EllipseReach(const Transform &t, bool withZ) {
    const Matrix4 &m = t.Matrix();
    const auto row = [&](int i) {
        return std::sqrt(Sqr(m[i][0]) + Sqr(m[i][1]) + (withZ ? Sqr(m[i][2]) : 0));
    };
    return {row(0), row(1), row(2)};
}

Bounds3f BoundsAround(const Transform &t, Point3f center, Vector3f half, Point3f far) {
    const Vector3f wide = half + Gamma(8) * AbsPoint(t.Matrix(), far);
    return {center - wide, center + wide};
}

Bounds3f TubeBounds(const Transform &t, float radius, float zMin, float zMax) {
    const Matrix4 &m = t.Matrix();
    const Vector3f along = Abs(Vector3f{m[0][2], m[1][2], m[2][2]}) * (0.5f * (zMax - zMin));
    return BoundsAround(t, t.Point({0, 0, 0.5f * (zMin + zMax)}),
                        radius * EllipseReach(t, false) + along,
                        {radius, radius, std::max(std::abs(zMin), std::abs(zMax))});
}

float Volume(const Transform &t) {
    const Matrix4 &m = t.Matrix();
    return AbsDot(Cross(Vector3f{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}),
                  Vector3f{m[0][2], m[1][2], m[2][2]});
}

}  // namespace pbrt
