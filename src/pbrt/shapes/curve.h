#pragma once

#include <algorithm>

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/surface_interaction.h"
#include "pbrt/shapes/types.h"
#include "pbrt/util/math.h"

namespace pbrt {

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

/// uv: u from 0 to 1 along each segment, v across the width, growing along dpdv. dpdu, dpdv and the
/// direction to the ray's origin are right-handed; left-handed where a transform has mirrored the
/// curve, be it an instance's or its own. A ray that leaves starts a whole width off, for the curve
/// turns to face it.
inline SurfaceInteraction CurveSurface(const CurveSet &curves, const Hit &hit, const Ray &ray) {
    const uint32_t first = curves.first[hit.primitive];
    const float u = std::clamp(hit.u, 0.f, 1.f);
    const CurveAt at(&curves.points[first], u);
    const Vector3f tangent = UnitOr(at.dpdu, {1, 0, 0});
    const Vector3f side = UnitCross(tangent, ray.d);
    const float width = 2 * at.radius;

    SurfaceInteraction s;
    s.p = ray(hit.t);
    const float v = width > 0 ? Dot(s.p - at.p, side) / width + 0.5f : 0.5f;
    s.uv = {u, std::clamp(v, 0.f, 1.f)};
    Normal3f n = UnitCross(tangent, side);
    Vector3f across = side;
    if (curves.type == CurveType::Cylinder) {
        const SinCos turn = SinCosTurns((s.uv.y - 0.5f) / 2);
        across = turn.cos * side - turn.sin * n;
        n = turn.cos * n + turn.sin * side;
    }
    s.n = s.ns = curves.flipNormal ? -n : n;
    s.pError = Abs(n) * width + Gamma(3) * Abs(s.p);
    s.dpdu = s.dpdus = at.dpdu;
    s.dpdv = width * across;
    if (curves.mirrored) {
        s.uv.y = 1 - s.uv.y;
        s.dpdv = -s.dpdv;
    }
    s.faceIndex = int(hit.primitive);
    return s;
}

}  // namespace pbrt
