#pragma once

#include <optional>

#include "pbrt/shapes/quadric.h"
#include "pbrt/shapes/sample_common.h"
#include "pbrt/util/math.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// |determinant| of the transform's linear part.
float Volume(const Transform &t);

/// Uniform scale of the transform, or 0 where it is more than a rotation with a uniform scale.
inline float UniformScale(const Transform &t) {
    const Matrix4 &m = t.Matrix();
    const Vector3f x{m[0][0], m[1][0], m[2][0]}, y{m[0][1], m[1][1], m[2][1]},
        z{m[0][2], m[1][2], m[2][2]};
    const float xx = LengthSquared(x), least = 1e-5f * xx;
    const bool similar = std::abs(LengthSquared(y) - xx) <= least &&
                         std::abs(LengthSquared(z) - xx) <= least && AbsDot(x, y) <= least &&
                         AbsDot(y, z) <= least && AbsDot(z, x) <= least;
    return similar ? std::sqrt(xx) : 0;
}

/// How much the transform stretches the area about a point with unit normal n in object space.
inline float AreaStretch(const Transform &t, Normal3f n) {
    return Volume(t) * Length(t.Normal(n));
}
/// The same from the unit normal n in rendering space; n goes back by the transpose.
inline float AreaStretchAt(const Transform &t, Normal3f n) {
    const Matrix4 &m = t.Matrix();
    const auto column = [&](int j) { return m[0][j] * n.x + m[1][j] * n.y + m[2][j] * n.z; };
    return Volume(t) / Length(Vector3f{column(0), column(1), column(2)});
}
/// A vector in object space.
inline Vector3f ObjectVector(const Transform &t, Vector3f v) {
    const Matrix4 &m = t.InverseMatrix();
    const auto row = [&](int i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z; };
    return {row(0), row(1), row(2)};
}

/// A point in object space with unit normal n and density 1 / area there.
inline ShapeSample QuadricSample(const Transform &t, Point3f p, Normal3f n, bool flipNormal,
                                 Point2f uv, float area) {
    const Normal3f out = t.Normal(n);
    const float length = Length(out);
    ShapeSample s;
    s.p = t.Point(p);
    s.pError = Gamma(6) * AbsPoint(t.Matrix(), p);
    s.n = out * ((flipNormal ? -1 : 1) / length);
    s.uv = uv;
    s.pdf = 1 / (area * Volume(t) * length);
    return s;
}

// Areas in object space.
inline float ObjectArea(const Sphere &s) {
    return s.phiMax * s.radius * (s.zMax - s.zMin);
}
inline float ObjectArea(const Disk &d) {
    return 0.5f * d.phiMax * (d.radius - d.innerRadius) * (d.radius + d.innerRadius);
}
inline float ObjectArea(const Cylinder &c) {
    return c.phiMax * c.radius * (c.zMax - c.zMin);
}

/// z and azimuth are uniform (Archimedes).
inline ShapeSample SampleQuadric(const Sphere &s, Point2f u) {
    const float z = Lerp(u.x, s.zMin, s.zMax);
    const SinCos phi = SinCosTurns(u.y * s.phiMax * (InvPi / 2));
    const float rho = SafeSqrt((s.radius - z) * (s.radius + z));
    const Point3f p{rho * phi.cos, rho * phi.sin, z};
    return QuadricSample(s.renderFromObject, p, p / s.radius, s.flipNormal, SphereUV(s, p),
                         ObjectArea(s));
}

inline ShapeSample SampleQuadric(const Disk &d, Point2f u) {
    const float r = std::sqrt(Lerp(u.x, Sqr(d.radius), Sqr(d.innerRadius)));
    const SinCos phi = SinCosTurns(u.y * d.phiMax * (InvPi / 2));
    return QuadricSample(d.renderFromObject, {r * phi.cos, r * phi.sin, d.height}, {0, 0, 1},
                         d.flipNormal, {u.y, (d.radius - r) / (d.radius - d.innerRadius)},
                         ObjectArea(d));
}

inline ShapeSample SampleQuadric(const Cylinder &c, Point2f u) {
    const SinCos phi = SinCosTurns(u.x * c.phiMax * (InvPi / 2));
    const Normal3f n{phi.cos, phi.sin, 0};
    return QuadricSample(c.renderFromObject,
                         {c.radius * n.x, c.radius * n.y, Lerp(u.y, c.zMin, c.zMax)}, n,
                         c.flipNormal, u, ObjectArea(c));
}

/// Density per area of SampleQuadric where the normal in rendering space is n.
template <typename Q>
inline float QuadricPDFArea(const Q &quadric, Normal3f n) {
    return 1 / (ObjectArea(quadric) * AreaStretchAt(quadric.renderFromObject, n));
}

/// A whole sphere that is one in rendering space too, and how a point outside sees it.
struct SeenSphere {
    Point3f center;
    float radius, distance2, oneMinusCosMax, sin2Max;

    /// None where the sphere is partial, stretched, or holds ref.
    static std::optional<SeenSphere> From(const Sphere &s, Point3f ref) {
        if (!s.IsFull()) return {};
        const float scale = UniformScale(s.renderFromObject);
        if (scale == 0) return {};
        const Matrix4 &m = s.renderFromObject.Matrix();
        SeenSphere seen;
        seen.center = {m[0][3], m[1][3], m[2][3]};
        seen.radius = s.radius * scale;
        seen.distance2 = DistanceSquared(seen.center, ref);
        // A sphere so near that all of its half sphere's rounding shows is drawn by area.
        if (!(seen.distance2 > Sqr(seen.radius) * (1 + 1e-5f))) return {};
        seen.sin2Max = Sqr(seen.radius) / seen.distance2;
        seen.oneMinusCosMax = seen.sin2Max / (1 + SafeSqrt(1 - seen.sin2Max));
        return seen;
    }

    float PDF() const { return UniformConePDF(oneMinusCosMax); }

    /// Uniform in the cone; the visible point on it from the triangle center, point, ref.
    ShapeSample Sample(const Sphere &s, Point3f ref, Point2f u) const {
        const float d = u.x * oneMinusCosMax;  // 1 - cos(theta), theta at ref
        const float cosTheta = 1 - d, sin2Theta = d * (2 - d);
        const float share = std::min(sin2Theta / sin2Max, 1.f);
        const float sinMax = std::sqrt(sin2Max);
        // alpha at the center: radius sin(alpha) = (distance to the point) sin(theta).
        const float cosAlpha = std::min(sin2Theta / sinMax + cosTheta * SafeSqrt(1 - share), 1.f);
        const float sinAlpha = std::sqrt(share) * (cosTheta - sinMax * SafeSqrt(1 - share));
        const SinCos phi = SinCosTurns(u.y);
        const Frame frame = Frame::FromZ(Normalize(ref - center));
        const Normal3f n =
            Normalize(frame.FromLocal({sinAlpha * phi.cos, sinAlpha * phi.sin, cosAlpha}));
        ShapeSample sample;
        sample.p = center + radius * n;
        sample.pError = Gamma(8) * (Abs(center) + Abs(radius * n));
        sample.n = s.flipNormal ? -n : n;
        sample.uv = SphereUV(s, ObjectVector(s.renderFromObject, n));
        sample.pdf = PDF();
        return sample;
    }
};

}  // namespace pbrt
