#include "pbrt/shapes/intersect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pbrt {

ObjectFromRender::ObjectFromRender(const Transform &renderFromObject) {
    const Matrix4 &f = renderFromObject.Matrix();
    const Vector3d x{f[0][0], f[1][0], f[2][0]}, y{f[0][1], f[1][1], f[2][1]},
        z{f[0][2], f[1][2], f[2][2]}, t{f[0][3], f[1][3], f[2][3]};
    const Vector3d yz = Cross(y, z), zx = Cross(z, x), xy = Cross(x, y);
    const double invDet = 1 / Dot(x, yz);
    const Vector3d rows[3] = {yz * invDet, zx * invDet, xy * invDet};
    for (int i = 0; i < 3; ++i) {
        m[i][0] = rows[i].x;
        m[i][1] = rows[i].y;
        m[i][2] = rows[i].z;
        m[i][3] = -Dot(rows[i], t);
    }
}

namespace {

struct Roots {
    double t0, t1;
};

/// Where a ray, given by its parts across an axis (circle) or in space (sphere), crosses radius r.
/// The discriminant comes from the distance at the closest approach (Hearn and Baker), the roots
/// without cancellation (Kahan). r, a float, has an exact square: signs are right for origins
/// 1e-15 r from the surface.
std::optional<Roots> CrossRadius(Vector3d o, Vector3d d, double r) {
    const double a = LengthSquared(d), b = -Dot(o, d), c = LengthSquared(o) - r * r;
    if (a == 0 || (c > 0 && b <= 0)) return {};
    const double discriminant = r * r - LengthSquared(o + (b / a) * d);
    if (discriminant < 0) return {};
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    if (q == 0) return Roots{0, 0};
    const double t = q / a, other = c / q;
    return t < other ? Roots{t, other} : Roots{other, t};
}

bool InAzimuth(double x, double y, float phiMax) {
    if (phiMax >= 2 * Pi) return true;
    double phi = std::atan2(y, x);
    if (phi < 0) phi += 2 * std::numbers::pi;
    return phi <= phiMax;
}

/// The nearer of two roots that lies in (tMin, tMax] and satisfies `keep(point)`.
template <typename F>
std::optional<double> FirstOf(const Roots &roots, const RayD &ray, F keep) {
    for (const double t : {roots.t0, roots.t1})
        if (t > ray.tMin && t <= ray.tMax && keep(ray.o + t * ray.d)) return t;
    return {};
}

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
            found(PatchHit{Dot(Cross(from, along), n) / n2, u, Dot(Cross(from, d), n) / n2});
    };
    if (k != 0) at(c / k);
    if (a != 0) at(k / a);
}

}  // namespace

std::optional<double> IntersectQuadric(const Sphere &sphere, const RayD &ray) {
    const auto roots = CrossRadius(ray.o, ray.d, sphere.radius);
    if (!roots) return {};
    if (sphere.IsFull()) return FirstOf(*roots, ray, [](Vector3d) { return true; });
    return FirstOf(*roots, ray, [&](Vector3d p) {
        return p.z >= sphere.zMin && p.z <= sphere.zMax && InAzimuth(p.x, p.y, sphere.phiMax);
    });
}

std::optional<double> IntersectQuadric(const Cylinder &cylinder, const RayD &ray) {
    const auto roots = CrossRadius({ray.o.x, ray.o.y, 0}, {ray.d.x, ray.d.y, 0}, cylinder.radius);
    if (!roots) return {};
    return FirstOf(*roots, ray, [&](Vector3d p) {
        return p.z >= cylinder.zMin && p.z <= cylinder.zMax && InAzimuth(p.x, p.y, cylinder.phiMax);
    });
}

std::optional<double> IntersectQuadric(const Disk &disk, const RayD &ray) {
    if (ray.d.z == 0) return {};
    const double t = (disk.height - ray.o.z) / ray.d.z;
    return FirstOf({t, t}, ray, [&](Vector3d p) {
        const double r2 = p.x * p.x + p.y * p.y;
        return r2 <= Sqr(double(disk.radius)) && r2 >= Sqr(double(disk.innerRadius)) &&
               InAzimuth(p.x, p.y, disk.phiMax);
    });
}

std::optional<PatchHit> IntersectPatch(const Patch &patch, const RayD &ray) {
    std::optional<PatchHit> nearest;
    MeetPatch(patch, ray.o, ray.d, [&](const PatchHit &hit) {
        const bool inside = hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.v <= 1;
        if (inside && hit.t > ray.tMin && hit.t <= ray.tMax && !(nearest && nearest->t <= hit.t))
            nearest = hit;
    });
    return nearest;
}

Point2f InvertPatch(const Patch &patch, Point3f p, Normal3f n) {
    PatchHit best{std::numeric_limits<double>::infinity(), 0.5, 0.5};
    MeetPatch(patch, ToDouble(p), ToDouble(n), [&](const PatchHit &hit) {
        if (std::abs(hit.t) < std::abs(best.t)) best = hit;
    });
    return {std::clamp(float(best.u), 0.f, 1.f), std::clamp(float(best.v), 0.f, 1.f)};
}

}  // namespace pbrt
