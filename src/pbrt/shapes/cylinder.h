#pragma once

#include <optional>
#include <string_view>

#include "pbrt/shapes/quadric.h"

namespace pbrt {

/// `Shape "cylinder"`: of `radius` about z, from zMin to zMax, up to phiMax; open at both ends.
struct Cylinder {
    static constexpr std::string_view kName = "cylinder";
    static constexpr ShapeTraits kTraits{
        .canEmit = true, .intersectsItself = true, .hasObjectSpace = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        R"("float zmin" 0)", R"("float radius" 2 "float phimax" 150)"};
    static std::optional<Cylinder> Create(const ShapeArguments &a) {
        QuadricReader reader(a);
        Cylinder c;
        c.radius = reader.Radius();
        reader.ZRange(&c.zMin, &c.zMax);
        c.phiMax = reader.PhiMax();
        return reader.Finish(c, {&Cylinder::radius, &Cylinder::zMin, &Cylinder::zMax});
    }

    size_t NPrimitives() const { return 1; }
    Bounds3f Bounds() const { return TubeBounds(renderFromObject, radius, zMin, zMax); }
    Bounds3f PrimitiveBounds(uint32_t) const { return Bounds(); }

    template <bool kWithError>
    SurfaceInteraction SurfaceAt(const Hit &hit, const Ray &ray) const;
    std::optional<PrimitiveHit> Intersect(uint32_t primitive, const RayD &ray) const;

    float Area(uint32_t) const { return ObjectArea() * MeanStretch(*this, 256, 1); }
    std::optional<ShapeSample> SampleArea(uint32_t, Point2f u) const {
        const SinCos phi = SinCosTurns(u.x * phiMax * (InvPi / 2));
        const Normal3f n{phi.cos, phi.sin, 0};
        return QuadricSample(renderFromObject, {radius * n.x, radius * n.y, Lerp(u.y, zMin, zMax)},
                             n, flipNormal, u, ObjectArea());
    }
    std::optional<ShapeSample> SampleFrom(uint32_t primitive, Point3f ref, Point2f u) const {
        return SeenFrom(SampleArea(primitive, u), ref);
    }
    float PDFFrom(uint32_t, Point3f ref, Point3f p, Normal3f n) const {
        return PerSolidAngle(QuadricPDFArea(*this, n), ref, p, n);
    }
    NormalCone NormalBounds(uint32_t) const { return {{0, 0, 1}, -1}; }
    float ObjectArea() const { return phiMax * radius * (zMax - zMin); }

    Transform renderFromObject;
    float radius = 1, zMin = -1, zMax = 1, phiMax = 2 * Pi;
    bool flipNormal = false;  ///< normals point inwards
};

template <bool kWithError>
inline SurfaceInteraction Cylinder::SurfaceAt(const Hit &hit, const Ray &ray) const {
    Vector3d p = ObjectPoint(renderFromObject, hit, ray);
    const double toSurface = radius / std::sqrt(p.x * p.x + p.y * p.y);
    p.x *= toSurface;
    p.y *= toSurface;
    const Vector3f q = ToFloat(p);
    const float height = zMax - zMin;
    return PlaceQuadric<kWithError>(renderFromObject, p, {q.x, q.y, 0}, flipNormal,
                                    phiMax * Vector3f{-q.y, q.x, 0}, {0, 0, height},
                                    {Azimuth(q.x, q.y) / phiMax, (q.z - zMin) / height});
}

inline std::optional<PrimitiveHit> Cylinder::Intersect(uint32_t, const RayD &ray) const {
    const auto roots = CrossRadius({ray.o.x, ray.o.y, 0}, {ray.d.x, ray.d.y, 0}, radius);
    if (!roots) return {};
    return FirstOf(*roots, ray, [&](Vector3d p) {
        return p.z >= zMin && p.z <= zMax && InAzimuth(p.x, p.y, phiMax);
    });
}

}  // namespace pbrt
