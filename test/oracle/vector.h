#pragma once

#include <cmath>

namespace pbrt::oracle {

/// The vane's frame or a segment's: x across the barbules, y along them, z the normal.
struct Vec3 {
    double x, y, z;
    friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};
inline double Dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// The mirror image of direction d in the plane with unit normal m.
inline Vec3 Mirrored(Vec3 d, Vec3 m) {
    return d + -2 * Dot(d, m) * m;
}

/// A point or direction of the plane across the barbules.
struct Vec2 {
    double x, z;
    friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.z + b.z}; }
    friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.z}; }
};
inline double Dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.z * b.z;
}

}  // namespace pbrt::oracle
