#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "pbrt/base/ray_tracer.h"
#include "pbrt/base/shape.h"
#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/triangle_mesh.h"
#include "pbrt/util/math.h"

namespace pbrt {

/// Both turn to the ray; one is shaded as flat, the other as a cylinder. Ribbons are meshes.
enum class CurveType { Flat, Cylinder };

/// A point of a curve's control polygon.
struct CurvePoint {
    Point3f p;
    float radius;  ///< half the width
};

/// `Shape "curve"`: cubic Bezier segments of one type, at most kMaxCurveSegments: 52 bytes each,
/// for neighbours share a point.
struct CurveSet {
    static constexpr std::string_view kName = "curve";
    static constexpr ShapeTraits kTraits{};
    static constexpr std::array<std::string_view, 3> kExamples{
        R"("point3 P" [ 0 0 0  1 1 0  2 -1 1  3 0 0 ])",
        R"("string type" "cylinder" "float width" 0.5 "string basis" "bspline"
            "point3 P" [ 0 0 0  1 2 0  2 -1 1  4 0 3  5 2 2 ])",
        R"("integer degree" 2 "float width0" 0.4 "float width1" 0.1
            "point3 P" [ 0 0 0  1 2 0  2 -1 1  4 0 3  5 2 2 ])"};
    /// A ribbon becomes triangles.
    static std::optional<std::variant<CurveSet, TriangleMesh>> Create(const ShapeArguments &a);

    size_t NPrimitives() const { return first.size(); }
    /// Segments lie in the hull of their points; with their width, in that of the points' spheres.
    Bounds3f Bounds() const { return BoundsOf(points.data(), points.size()); }
    Bounds3f PrimitiveBounds(uint32_t primitive) const {
        return BoundsOf(&points[first[primitive]], 4);
    }
    /// uv: u from 0 to 1 along each segment, v across the width, growing along dpdv: to the left of
    /// dpdu as seen along the ray, as in pbrt-v4; to the right where a transform has
    /// mirrored the curve, be it an instance's or its own.
    ///
    /// A ray that leaves passes the point a whole width off along each axis, as in pbrt-v4, for the
    /// curve turns to face it: half of that is enough for it not to meet the curve again. Embree
    /// ignores curves that a ray meets within their width of its origin, so the origin lies a width
    /// further back: the ray then meets all curves ahead, and none behind.
    template <bool kWithError>
    SurfaceInteraction SurfaceAt(const Hit &hit, const Ray &ray) const;

    std::vector<uint32_t> first;     ///< per segment: its first point of four
    std::vector<CurvePoint> points;  ///< rendering space (object's space of an instance)
    CurveType type = CurveType::Flat;
    bool flipNormal = false;  ///< ReverseOrientation alone: normals face away from the ray
    bool mirrored = false;    ///< by a left-handed transform: v runs to the other side

  private:
    static Bounds3f BoundsOf(const CurvePoint *c, size_t count);
};

/// Adds the curves of `more` to `into`; false, and nothing done, where their kinds differ or they
/// would be more than kMaxCurveSegments.
bool Append(const CurveSet &more, CurveSet *into);

/// Point, derivative and radius of a cubic Bezier segment at u.
struct CurveAt {
    Point3f p;
    Vector3f dpdu;
    float radius;

    CurveAt(const CurvePoint *c, float u) {
        const float v = 1 - u;
        const float b0 = v * v * v, b1 = 3 * v * v * u, b2 = 3 * v * u * u, b3 = u * u * u;
        p = b0 * c[0].p + b1 * c[1].p + b2 * c[2].p + b3 * c[3].p;
        dpdu = 3.f * (v * v * (c[1].p - c[0].p) + 2.f * v * u * (c[2].p - c[1].p) +
                      u * u * (c[3].p - c[2].p));
        // Where control points coincide the curve still has a direction, its chord's.
        if (!(LengthSquared(dpdu) > 0)) dpdu = c[3].p - c[0].p;
        radius = b0 * c[0].radius + b1 * c[1].radius + b2 * c[2].radius + b3 * c[3].radius;
    }
};

template <bool>
inline SurfaceInteraction CurveSet::SurfaceAt(const Hit &hit, const Ray &ray) const {
    const float u = std::clamp(hit.u, 0.f, 1.f);
    const CurveAt at(&points[first[hit.primitive]], u);
    const Vector3f tangent = UnitOr(at.dpdu, {1, 0, 0});
    const Vector3f side = UnitCross(tangent, ray.d);
    const float width = 2 * at.radius;

    SurfaceInteraction s;
    s.p = ray(hit.t);
    // From -1/2 to 1/2, growing to the right of the tangent as seen along the ray.
    const float right = width > 0 ? std::clamp(Dot(s.p - at.p, side) / width, -0.5f, 0.5f) : 0.f;
    s.uv = {u, 0.5f + (mirrored ? right : -right)};
    Normal3f n = UnitCross(tangent, side);
    Vector3f across = side;
    if (type == CurveType::Cylinder) {
        const SinCos turn = SinCosTurns(right / 2);
        across = turn.cos * side - turn.sin * n;
        n = turn.cos * n + turn.sin * side;
    }
    s.n = s.ns = flipNormal ? -n : n;
    s.pError = Vector3f{width, width, width} + Gamma(3) * Abs(s.p);
    s.startBehind = width;
    s.dpdu = s.dpdus = at.dpdu;
    s.dpdv = (mirrored ? width : -width) * across;
    s.faceIndex = int(hit.primitive);
    return s;
}

}  // namespace pbrt
