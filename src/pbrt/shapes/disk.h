#pragma once

#include <optional>
#include <string_view>

#include "pbrt/shapes/quadric.h"

namespace pbrt {

/// `Shape "disk"`: in z = height, from innerRadius to radius, up to phiMax. Its normal
/// points along +z.
struct Disk {
    static constexpr std::string_view kName = "disk";
    static constexpr ShapeTraits kTraits{
        .canEmit = true, .intersectsItself = true, .hasObjectSpace = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        "", R"("float height" 0.3 "float innerradius" 0.5 "float phimax" 200)"};
    static constexpr FloatParam kHeight{"height", "", 0, -kOpen, kOpen, "z of the disk"};
    static constexpr FloatParam kInnerRadius{
        "innerradius", "", 0, 0, kOpen, "radius of the hole, less than radius"};
    static std::optional<Disk> Create(const ShapeArguments &a) {
        QuadricReader reader(a);
        Disk d;
        d.height = reader.Float(kHeight);
        d.radius = reader.Radius();
        d.innerRadius = reader.FloatBelow(kInnerRadius, d.radius);
        d.phiMax = reader.PhiMax();
        return reader.Finish(d, {&Disk::radius, &Disk::innerRadius, &Disk::height});
    }

    size_t NPrimitives() const { return 1; }
    Bounds3f Bounds() const { return TubeBounds(renderFromObject, radius, height, height); }
    Bounds3f PrimitiveBounds(uint32_t) const { return Bounds(); }

    template <bool kWithError>
    SurfaceInteraction SurfaceAt(const Hit &hit, const Ray &ray) const;
    std::optional<PrimitiveHit> Intersect(uint32_t primitive, const RayD &ray) const;

    float Area(uint32_t) const { return ObjectArea() * AreaStretch(renderFromObject, {0, 0, 1}); }
    std::optional<ShapeSample> SampleArea(uint32_t primitive, Point2f u) const;
    std::optional<ShapeSample> SampleFrom(uint32_t primitive, Point3f ref, Point2f u) const {
        return SeenFrom(SampleArea(primitive, u), ref);
    }
    float PDFFrom(uint32_t, Point3f ref, Point3f p, Normal3f n) const {
        return PerSolidAngle(QuadricPDFArea(*this, n), ref, p, n);
    }
    NormalCone NormalBounds(uint32_t) const {
        const Normal3f n = Normalize(renderFromObject.Normal({0, 0, 1}));
        return {flipNormal ? -n : n, 1};
    }
    float ObjectArea() const {
        return 0.5f * phiMax * (radius - innerRadius) * (radius + innerRadius);
    }

    Transform renderFromObject;
    float height = 0, radius = 1, innerRadius = 0, phiMax = 2 * Pi;
    bool flipNormal = false;  ///< normals point along -z
};

template <bool kWithError>
inline SurfaceInteraction Disk::SurfaceAt(const Hit &hit, const Ray &ray) const {
    Vector3d p = ObjectPoint(renderFromObject, hit, ray);
    p.z = height;
    const float x = float(p.x), y = float(p.y), width = radius - innerRadius;
    const float r = std::sqrt(Sqr(x) + Sqr(y)), least = 1e-5f * radius;
    const float cosPhi = r > least ? x / r : 1, sinPhi = r > least ? y / r : 0;
    const Vector3f dpdu = phiMax * std::max(r, least) * Vector3f{-sinPhi, cosPhi, 0};
    const Vector3f dpdv = -width * Vector3f{cosPhi, sinPhi, 0};
    return PlaceQuadric<kWithError>(renderFromObject, p, {0, 0, 1}, flipNormal, dpdu, dpdv,
                                    {Azimuth(x, y) / phiMax, (radius - r) / width});
}

inline std::optional<PrimitiveHit> Disk::Intersect(uint32_t, const RayD &ray) const {
    if (ray.d.z == 0) return {};
    const double t = (height - ray.o.z) / ray.d.z;
    return FirstOf({t, t}, ray, [&](Vector3d p) {
        const double r2 = p.x * p.x + p.y * p.y;
        return r2 <= Sqr(double(radius)) && r2 >= Sqr(double(innerRadius)) &&
               InAzimuth(p.x, p.y, phiMax);
    });
}

inline std::optional<ShapeSample> Disk::SampleArea(uint32_t, Point2f u) const {
    const float r = std::sqrt(Lerp(u.x, Sqr(radius), Sqr(innerRadius)));
    const SinCos phi = SinCosTurns(u.y * phiMax * (InvPi / 2));
    return QuadricSample(renderFromObject, {r * phi.cos, r * phi.sin, height}, {0, 0, 1},
                         flipNormal, {u.y, (radius - r) / (radius - innerRadius)}, ObjectArea());
}

}  // namespace pbrt
