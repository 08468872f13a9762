#include "pbrt/shapes/sphere.h"

#include <fmt/format.h>

#include <algorithm>

namespace pbrt {

std::optional<Sphere> Sphere::Create(const ShapeArguments &a) {
    QuadricReader reader(a);
    Sphere s;
    s.radius = reader.Radius();
    s.zMin = -s.radius;
    s.zMax = s.radius;
    reader.ZRange(&s.zMin, &s.zMax);
    if (s.zMin >= s.radius || s.zMax <= -s.radius)
        reader.Fail(QuadricReader::kZMin.name,
                    fmt::format("zmin, {}, to zmax, {}, leaves nothing of the radius, {}", s.zMin,
                                s.zMax, s.radius));
    s.zMin = std::max(s.zMin, -s.radius);
    s.zMax = std::min(s.zMax, s.radius);
    s.phiMax = reader.PhiMax();
    return reader.Finish(s, {&Sphere::radius, &Sphere::zMin, &Sphere::zMax});
}

Bounds3f Sphere::Bounds() const {
    const Transform &t = renderFromObject;
    const Bounds3f whole =
        BoundsAround(t, t.Point({}), radius * EllipseReach(t, true), {radius, radius, radius});
    const Bounds3f tube = TubeBounds(t, radius, zMin, zMax);
    return {Max(whole.min, tube.min), Min(whole.max, tube.max)};
}

std::optional<PrimitiveHit> Sphere::Intersect(uint32_t, const RayD &ray) const {
    const auto roots = CrossRadius(ray.o, ray.d, radius);
    if (!roots) return {};
    if (IsFull()) return FirstOf(*roots, ray, [](Vector3d) { return true; });
    return FirstOf(*roots, ray, [&](Vector3d p) {
        return p.z >= zMin && p.z <= zMax && InAzimuth(p.x, p.y, phiMax);
    });
}

namespace {

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
        sample.uv = s.UV(ObjectVector(s.renderFromObject, n));
        sample.pdf = PDF();
        return sample;
    }
};

}  // namespace

float Sphere::Area(uint32_t) const {
    const float scale = UniformScale(renderFromObject);
    return ObjectArea() * (scale > 0 ? Sqr(scale) : MeanStretch(*this, 128, 128));
}

/// z and azimuth are uniform (Archimedes).
std::optional<ShapeSample> Sphere::SampleArea(uint32_t, Point2f u) const {
    const float z = Lerp(u.x, zMin, zMax);
    const SinCos phi = SinCosTurns(u.y * phiMax * (InvPi / 2));
    const float rho = SafeSqrt((radius - z) * (radius + z));
    const Point3f p{rho * phi.cos, rho * phi.sin, z};
    return QuadricSample(renderFromObject, p, p / radius, flipNormal, UV(p), ObjectArea());
}

std::optional<ShapeSample> Sphere::SampleFrom(uint32_t primitive, Point3f ref, Point2f u) const {
    if (const auto seen = SeenSphere::From(*this, ref)) return seen->Sample(*this, ref, u);
    return SeenFrom(SampleArea(primitive, u), ref);
}

float Sphere::PDFFrom(uint32_t, Point3f ref, Point3f p, Normal3f n) const {
    if (const auto seen = SeenSphere::From(*this, ref)) return seen->PDF();
    return PerSolidAngle(QuadricPDFArea(*this, n), ref, p, n);
}

}  // namespace pbrt
