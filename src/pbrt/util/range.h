#pragma once

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// The ray tracer takes no ray whose origin or direction has a coordinate beyond 1.844e18, and
/// leaves out what lies beyond.
inline constexpr float kMostTraced = 1.8e18f;

/// Coordinates of all that stands in a scene, or in an object by itself. The longest direction is
/// that of a shadow ray to a light at infinity, which ends twice the scene's radius away: 2 sqrt(3)
/// times this.
inline constexpr float kFarthest = 5e17f;

/// Lengths whose squares a float holds with all its digits.
inline constexpr float kShortestVector = 1e-18f, kLongestVector = 1e18f;

/// False for what is not finite, too.
inline bool IsInRange(Point3f p) {
    return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest;
}
inline bool IsInRange(const Bounds3f &b) {
    return IsInRange(b.min) && IsInRange(b.max);
}
/// The largest coordinate of a point in b, without its sign.
inline float Reach(const Bounds3f &b) {
    return MaxComponent(Max(Abs(b.min), Abs(b.max)));
}

inline bool HasSafeLength(Vector3f v) {
    const float length = Length(v);
    return length >= kShortestVector && length <= kLongestVector;
}

}  // namespace pbrt
