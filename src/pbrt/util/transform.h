#pragma once

#include <array>
#include <optional>

#include "pbrt/util/matrix.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// The upper left part of m, transposed, applied to v: a normal's transform, m being the inverse.
template <typename M, typename T>
inline Vec3<T> Transposed(const M &m, Vec3<T> v) {
    return {m[0][0] * v.x + m[1][0] * v.y + m[2][0] * v.z,
            m[0][1] * v.x + m[1][1] * v.y + m[2][1] * v.z,
            m[0][2] * v.x + m[1][2] * v.y + m[2][2] * v.z};
}

/// Affine (or projective) map with its inverse. Composition: (A * B)(p) = A(B(p)).
class Transform {
  public:
    Transform() = default;
    /// nullopt where m has no inverse.
    static std::optional<Transform> FromMatrix(const Matrix4 &m);
    static Transform FromMatrixPair(const Matrix4 &m, const Matrix4 &inverse) {
        return Transform(m, inverse);
    }
    static Transform Translate(Vector3f t);
    /// nullopt where a factor is 0.
    static std::optional<Transform> Scale(Vector3f s);
    /// nullopt where the axis is 0. `degrees`, right-handed.
    static std::optional<Transform> Rotate(float degrees, Vector3f axis);
    /// Camera from world, left-handed camera space as pbrt's; nullopt where up is parallel to the
    /// view or the eye stands on the target.
    static std::optional<Transform> LookAt(Point3f eye, Point3f look, Vector3f up);
    /// Screen from camera for a vertical field of view of `fov` degrees in (0, 180).
    static Transform Perspective(float fov, float near, float far);

    const Matrix4 &Matrix() const { return m; }
    const Matrix4 &InverseMatrix() const { return mInv; }
    Transform Inverse() const { return Transform(mInv, m); }
    Transform operator*(const Transform &b) const;
    bool operator==(const Transform &) const = default;
    /// True where the map turns right-handed frames into left-handed ones.
    bool SwapsHandedness() const;

    /// Transforms a point, dividing by w where the last row is not (0, 0, 0, 1).
    Point3f Point(Point3f p) const {
        const float x = m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3];
        const float y = m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + m[1][3];
        const float z = m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + m[2][3];
        const float w = m[3][0] * p.x + m[3][1] * p.y + m[3][2] * p.z + m[3][3];
        return w == 1 ? Point3f{x, y, z} : Point3f{x / w, y / w, z / w};
    }
    Vector3f Vector(Vector3f v) const { return Vector<float>(v); }
    template <typename T>
    Vec3<T> Vector(Vec3<T> v) const {
        return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
                m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
    }
    /// Transforms a normal by the inverse transpose; not normalised.
    Normal3f Normal(Normal3f n) const { return Transposed(mInv, n); }
    Bounds3f Bounds(const Bounds3f &b) const;

  private:
    Transform(const Matrix4 &m, const Matrix4 &inverse) : m(m), mInv(inverse) {}
    static constexpr Matrix4 kIdentity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    Matrix4 m = kIdentity, mInv = kIdentity;
};

/// An affine Transform in three quarters of its memory.
class AffineTransform {
  public:
    AffineTransform() : AffineTransform(Transform()) {}
    /// t IsAffine.
    explicit AffineTransform(const Transform &t) {
        for (size_t i = 0; i < 3; ++i)
            m[i] = t.Matrix()[i], mInv[i] = t.InverseMatrix()[i];
    }
    // The inverse map, of one or of sixteen.
    template <typename T>
    Vec3<T> InversePoint(const Vec3<T> &p) const {
        return {mInv[0][0] * p.x + mInv[0][1] * p.y + mInv[0][2] * p.z + mInv[0][3],
                mInv[1][0] * p.x + mInv[1][1] * p.y + mInv[1][2] * p.z + mInv[1][3],
                mInv[2][0] * p.x + mInv[2][1] * p.y + mInv[2][2] * p.z + mInv[2][3]};
    }
    template <typename T>
    Vec3<T> InverseVector(const Vec3<T> &v) const {
        return {mInv[0][0] * v.x + mInv[0][1] * v.y + mInv[0][2] * v.z,
                mInv[1][0] * v.x + mInv[1][1] * v.y + mInv[1][2] * v.z,
                mInv[2][0] * v.x + mInv[2][1] * v.y + mInv[2][2] * v.z};
    }
    Transform Whole() const {
        constexpr std::array<float, 4> last{0, 0, 0, 1};
        return Transform::FromMatrixPair({{m[0], m[1], m[2], last}},
                                         {{mInv[0], mInv[1], mInv[2], last}});
    }

  private:
    std::array<std::array<float, 4>, 3> m, mInv;
};

inline bool IsAffine(const Transform &t) {
    constexpr std::array<float, 4> last{0, 0, 0, 1};
    return t.Matrix()[3] == last;
}

}  // namespace pbrt
