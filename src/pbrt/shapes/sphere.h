#pragma once

#include <optional>
#include <string_view>

#include "pbrt/shapes/quadric.h"

namespace pbrt {

/// `Shape "sphere"`: of `radius` about 0, cut at zMin, zMax and phiMax.
struct Sphere {
    static constexpr std::string_view kName = "sphere";
    static constexpr ShapeTraits kTraits{
        .canEmit = true, .intersectsItself = true, .hasObjectSpace = true, .fewestWide = 3};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", R"("float radius" 0.5)", R"("float zmin" -0.5 "float zmax" 0.8 "float phimax" 250)"};
    static std::optional<Sphere> Create(const ShapeArguments &a);

    size_t NPrimitives() const { return 1; }
    bool IsFull() const { return zMin <= -radius && zMax >= radius && phiMax >= 2 * Pi; }
    Bounds3f Bounds() const;
    Bounds3f PrimitiveBounds(uint32_t) const { return Bounds(); }

    template <bool kWithError>
    SurfaceInteraction SurfaceAt(const Hit &hit, const Ray &ray) const;
    /// Tangents have their branches at the poles.
    template <bool kWithTangents>
    bool IsWide() const {
        return !kWithTangents;
    }
    template <bool kWithTangents>
    static SurfaceInteractionX16 SurfacesAt(const ShapePacket<Sphere> &spheres, const RayHits &met,
                                            LaneBits active);
    std::optional<PrimitiveHit> Intersect(uint32_t primitive, const RayD &ray) const;

    // By the cone of directions that a whole, round one fills.
    float Area(uint32_t primitive) const;
    std::optional<ShapeSample> SampleArea(uint32_t primitive, Point2f u) const;
    std::optional<ShapeSample> SampleFrom(uint32_t primitive, Point3f ref, Point2f u) const;
    float PDFFrom(uint32_t primitive, Point3f ref, Point3f p, Normal3f n) const;
    NormalCone NormalBounds(uint32_t) const { return {{0, 0, 1}, -1}; }

    float ObjectArea() const { return phiMax * radius * (zMax - zMin); }
    // Polar angles of the lower and upper rim, pi and 0 where it is whole.
    float ThetaZMin() const { return zMin <= -radius ? Pi : std::acos(zMin / radius); }
    float ThetaZMax() const { return zMax >= radius ? 0 : std::acos(zMax / radius); }
    /// (u, v) of a point in object space: u along the azimuth, v from zmin to zmax.
    Point2f UV(Vector3f p) const {
        const float thetaMin = ThetaZMin(), thetaMax = ThetaZMax();
        const float theta = FastAtan2(std::sqrt(Sqr(p.x) + Sqr(p.y)), p.z);
        return {Azimuth(p.x, p.y) / phiMax, (theta - thetaMin) / (thetaMax - thetaMin)};
    }

    Transform renderFromObject;
    float radius = 1, zMin = -1, zMax = 1, phiMax = 2 * Pi;
    bool flipNormal = false;  ///< normals point inwards
};

/// A point near the sphere moved onto it.
template <typename D, typename T>
inline Vec3<D> OnSphere(const Vec3<D> &p, T radius) {
    const D scale = ToDouble(radius) / Sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    return {p.x * scale, p.y * scale, p.z * scale};
}

template <bool kWithError>
inline SurfaceInteraction Sphere::SurfaceAt(const Hit &hit, const Ray &ray) const {
    const Vector3d p = OnSphere(ObjectPoint(renderFromObject, hit, ray), radius);
    const Vector3f q = ToFloat(p);
    // At the poles dpdu vanishes; keep a direction.
    const float rho = std::sqrt(Sqr(q.x) + Sqr(q.y)), least = 1e-5f * radius;
    const float cosPhi = rho > least ? q.x / rho : 1, sinPhi = rho > least ? q.y / rho : 0;
    const float dTheta = ThetaZMax() - ThetaZMin();
    const Vector3f dpdu = phiMax * std::max(rho, least) * Vector3f{-sinPhi, cosPhi, 0};
    const Vector3f dpdv = dTheta * Vector3f{q.z * cosPhi, q.z * sinPhi, -rho};
    return PlaceQuadric<kWithError>(renderFromObject, p, q, flipNormal, dpdu, dpdv, UV(q));
}

template <bool>
inline SurfaceInteractionX16 Sphere::SurfacesAt(const ShapePacket<Sphere> &spheres,
                                                const RayHits &met, LaneBits) {
    MatrixX16 renderFromObject, objectFromRender;
    FloatX16 radius;
    LaneBits flipped = 0;
    for (int i = 0; i < kPacketSize; ++i) {
        const Sphere &sphere = *spheres[size_t(i)];
        for (size_t row = 0; row < 3; ++row)
            for (size_t k = 0; k < 4; ++k) {
                renderFromObject[row][k].Set(i, sphere.renderFromObject.Matrix()[row][k]);
                objectFromRender[row][k].Set(i, sphere.renderFromObject.InverseMatrix()[row][k]);
            }
        radius.Set(i, sphere.radius);
        flipped |= LaneBits(sphere.flipNormal) << i;
    }
    const Vec3<DoubleX16> p =
        OnSphere(ObjectPoint(objectFromRender, met.o, met.d, met.hit.t), radius);
    SurfaceInteractionX16 s;
    PlaceQuadric<true>(renderFromObject, objectFromRender, p, ToFloat(p), MaskOf(flipped), &s);
    return s;
}

}  // namespace pbrt
