#pragma once

#include "pbrt/simd/math.h"
#include "pbrt/simd/memory.h"
#include "pbrt/simd/permute.h"
#include "pbrt/util/hash.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

// Points, vectors and frames of sixteen at once.

using Vector3fX16 = Vec3<FloatX16>;
using Point3fX16 = Vec3<FloatX16>;
using Normal3fX16 = Vec3<FloatX16>;
using Point2fX16 = Vec2<FloatX16>;
using FrameX16 = FrameT<FloatX16>;

template <int N>
inline Vec3<Simd<float, N>> Broadcast(Vector3f v) {
    return {v.x, v.y, v.z};
}
template <typename M, typename T>
inline Vec3<T> Select(const M &mask, const Vec3<T> &a, const Vec3<T> &b) {
    return {Select(mask, a.x, b.x), Select(mask, a.y, b.y), Select(mask, a.z, b.z)};
}
template <typename M, typename T>
inline Vec2<T> Select(const M &mask, const Vec2<T> &a, const Vec2<T> &b) {
    return {Select(mask, a.x, b.x), Select(mask, a.y, b.y)};
}
inline Vec3<FloatX16> operator*(float s, const Vec3<FloatX16> &a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline Vec3<FloatX16> Max(const Vec3<FloatX16> &a, const Vec3<FloatX16> &b) {
    return {Max(a.x, b.x), Max(a.y, b.y), Max(a.z, b.z)};
}
inline Vec3<FloatX16> FaceForward(const Vec3<FloatX16> &n, const Vec3<FloatX16> &v) {
    return Select(Dot(n, v) < 0, -n, n);
}

/// As that of one number: the 24 upper bits as a number in [0, 1).
inline FloatX16 ToUnitFloat(const UintX16 &bits) {
    return ToFloat(bits >> 8) * 0x1p-24f;
}

/// Number i of the sixteen.
inline Vector3f Lane(const Vec3<FloatX16> &v, int i) {
    return {v.x[i], v.y[i], v.z[i]};
}
inline Point2f Lane(const Vec2<FloatX16> &v, int i) {
    return {v.x[i], v.y[i]};
}
inline void SetLane(FloatX16 *v, int i, float value) {
    v->Set(i, value);
}
inline void SetLane(Vec3<FloatX16> *v, int i, Vector3f value) {
    v->x.Set(i, value.x), v->y.Set(i, value.y), v->z.Set(i, value.z);
}
inline void SetLane(Vec2<FloatX16> *v, int i, Point2f value) {
    v->x.Set(i, value.x), v->y.Set(i, value.y);
}
inline void SetLane(FrameX16 *frame, int i, const Frame &value) {
    SetLane(&frame->x, i, value.x);
    SetLane(&frame->y, i, value.y);
    SetLane(&frame->z, i, value.z);
}

}  // namespace pbrt
