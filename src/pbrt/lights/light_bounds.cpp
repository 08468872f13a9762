#include "pbrt/lights/light_bounds.h"

namespace pbrt {
namespace {

float SafeACos(float x) {
    return std::acos(std::clamp(x, -1.f, 1.f));
}

/// Unions may leave out a cone's margin of 1e-6 in the cosine, which is this angle at its widest;
/// clusters make up for it.
constexpr float kMarginCosine = 1e-6f, kMarginAngle = 2e-3f;

/// True where `inner` lies in `outer`, within the margin: the angle between the axes plus the inner
/// one's half angle is at most the outer one's. Without arcs, since trees ask this very often.
bool Holds(const DirectionCone &outer, const DirectionCone &inner) {
    if (outer.cosTheta <= -1) return true;
    const float cosAxes = Dot(outer.axis, inner.axis), c = inner.cosTheta;
    if (cosAxes < -c) return false;  // the sum exceeds pi
    return cosAxes * c - SafeSqrt(1 - Sqr(cosAxes)) * SafeSqrt(1 - Sqr(c)) >=
           outer.cosTheta - kMarginCosine;
}

}  // namespace

DirectionCone Union(const DirectionCone &a, const DirectionCone &b) {
    if (Holds(a, b)) return a;
    if (Holds(b, a)) return b;
    const float thetaA = SafeACos(a.cosTheta), thetaB = SafeACos(b.cosTheta);
    const float between = AngleBetween(a.axis, b.axis);
    // The union spans thetaA beyond one axis to thetaB beyond the other.
    const float theta = (thetaA + between + thetaB) / 2;
    if (theta >= Pi) return {a.axis, -1};
    const Vector3f across = b.axis - Dot(a.axis, b.axis) * a.axis;
    const float length = Length(across);
    if (length == 0)
        return between < 1 ? DirectionCone{a.axis, std::cos(theta)} : DirectionCone{a.axis, -1};
    const float turn = theta - thetaA;
    const Vector3f axis = Normalize(std::cos(turn) * a.axis + (std::sin(turn) / length) * across);
    return {axis, std::cos(theta)};
}

LightBounds Union(const LightBounds &a, const LightBounds &b) {
    if (a.power == 0) return b;
    if (b.power == 0) return a;
    LightBounds u = a;
    u.bounds.Grow(b.bounds);
    u.normals = Union(a.normals, b.normals);
    u.cosTheta_e = std::min(a.cosTheta_e, b.cosTheta_e);
    u.power += b.power;
    u.twoSided |= b.twoSided;
    return u;
}

ClusterOf<float> Cluster(const LightBounds &b) {
    const Point3f center = b.bounds.Center();
    const Vector3f axis = b.normals.axis;
    // A little more than the sphere round the box, so that rounding leaves nothing outside. Its
    // square must not be 0.
    const float radius = std::max(Length(b.bounds.max - center) * 1.00005f, 1e-15f);
    const float theta_o = std::min(Pi, SafeACos(b.normals.cosTheta) + kMarginAngle);
    return {center,       radius,
            axis,         2 * std::sin(theta_o / 2),
            b.cosTheta_e, b.twoSided ? -b.power : b.power};
}

float Importance(const LightBounds &light, Point3f p, Normal3f n) {
    return Importance(Cluster(light), Receiver(p, n));
}

}  // namespace pbrt
