#pragma once

#include <optional>

#include "pbrt/base/shape.h"

namespace pbrt {

/// Density per solid angle of what has density pdfArea per area at p with normal n; 0 seen edge-on.
inline float PerSolidAngle(float pdfArea, Point3f ref, Point3f p, Normal3f n) {
    const Vector3f d = p - ref;
    const float distance2 = LengthSquared(d);
    const float cosTimesDistance = AbsDot(n, d);
    if (!(cosTimesDistance > 0)) return 0;
    const float pdf = pdfArea * distance2 * std::sqrt(distance2) / cosTimesDistance;
    return pdf < Infinity ? pdf : 0;
}

/// An area sample turned into one per solid angle; none where it is seen edge-on.
inline std::optional<ShapeSample> SeenFrom(std::optional<ShapeSample> s, Point3f ref) {
    if (!s) return {};
    s->pdf = PerSolidAngle(s->pdf, ref, s->p, s->n);
    if (s->pdf == 0) return {};
    return s;
}

}  // namespace pbrt
