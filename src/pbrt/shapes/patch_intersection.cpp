#include "pbrt/shapes/patch_intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pbrt {
namespace {

// A line of constant u runs from a(u) = p00 + u e10 along l(u) = e00 + u q. The ray meets it where
// det(d, l, a - o) = 0, quadratic in u; then t and v follow from the two lines' common normal.
/// Calls found(t, u, v) for the at most two points of the unbounded surface on the line.
template <typename F>
void MeetPatch(const Patch &patch, Vector3d origin, Vector3d d, F found) {
    const Vector3d p00 = ToDouble(patch.p00), p10 = ToDouble(patch.p10), p01 = ToDouble(patch.p01),
                   p11 = ToDouble(patch.p11);
    const Vector3d e10 = p10 - p00, e00 = p01 - p00, q = (p11 - p10) - e00, o = p00 - origin;
    const Vector3d dq = Cross(d, q), de = Cross(d, e00);
    const double a = Dot(dq, e10), b = Dot(de, e10) + Dot(dq, o), c = Dot(de, o);
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return;
    const double k = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const auto at = [&](double u) {
        const Vector3d from = o + u * e10, along = e00 + u * q;
        const Vector3d n = Cross(d, along);
        const double n2 = LengthSquared(n);
        if (n2 > 0)
            found(PrimitiveHit{Dot(Cross(from, along), n) / n2, u, Dot(Cross(from, d), n) / n2});
    };
    if (k != 0) at(c / k);
    if (a != 0) at(k / a);
}

}  // namespace

std::optional<PrimitiveHit> IntersectPatch(const Patch &patch, const RayD &ray) {
    std::optional<PrimitiveHit> nearest;
    MeetPatch(patch, ray.o, ray.d, [&](const PrimitiveHit &hit) {
        const bool inside = hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.v <= 1;
        if (inside && hit.t > ray.tMin && hit.t <= ray.tMax && !(nearest && nearest->t <= hit.t))
            nearest = hit;
    });
    return nearest;
}

Point2f InvertPatch(const Patch &patch, Point3f p, Normal3f n) {
    PrimitiveHit best{std::numeric_limits<double>::infinity(), 0.5, 0.5};
    MeetPatch(patch, ToDouble(p), ToDouble(n), [&](const PrimitiveHit &hit) {
        if (std::abs(hit.t) < std::abs(best.t)) best = hit;
    });
    return {std::clamp(float(best.u), 0.f, 1.f), std::clamp(float(best.v), 0.f, 1.f)};
}

}  // namespace pbrt
