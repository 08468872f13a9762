#include "pbrt/util/transform.h"

#include <cmath>

namespace pbrt {
namespace {

/// Gauss-Jordan elimination with row pivoting, in double.
std::optional<Matrix4> Inverted(const Matrix4 &m) {
    double a[4][8] = {};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j)
            a[i][j] = m[i][j];
        a[i][4 + i] = 1;
    }
    for (int column = 0; column < 4; ++column) {
        int pivot = column;
        for (int row = column + 1; row < 4; ++row)
            if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
        const double p = a[pivot][column];
        if (p == 0 || !std::isfinite(p)) return {};
        for (int j = 0; j < 8; ++j)
            std::swap(a[column][j], a[pivot][j]);
        for (int j = 0; j < 8; ++j)
            a[column][j] /= p;
        for (int row = 0; row < 4; ++row) {
            const double f = a[row][column];
            if (row == column || f == 0) continue;
            for (int j = 0; j < 8; ++j)
                a[row][j] -= f * a[column][j];
        }
    }
    Matrix4 inverse;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            inverse[i][j] = float(a[i][4 + j]);
    return inverse;
}

}  // namespace

std::optional<Transform> Transform::FromMatrix(const Matrix4 &m) {
    const std::optional<Matrix4> inverse = Inverted(m);
    if (!inverse) return {};
    return Transform(m, *inverse);
}

Transform Transform::Translate(Vector3f t) {
    Transform r;
    for (int i = 0; i < 3; ++i)
        r.m[i][3] = t[i], r.mInv[i][3] = -t[i];
    return r;
}

std::optional<Transform> Transform::Scale(Vector3f s) {
    if (s.x == 0 || s.y == 0 || s.z == 0) return {};
    Transform r;
    for (int i = 0; i < 3; ++i)
        r.m[i][i] = s[i], r.mInv[i][i] = 1 / s[i];
    return r;
}

std::optional<Transform> Transform::Rotate(float degrees, Vector3f axis) {
    const double length =
        std::sqrt(double(axis.x) * axis.x + double(axis.y) * axis.y + double(axis.z) * axis.z);
    if (!(length > 0)) return {};
    const double angle = degrees * (3.14159265358979323846 / 180);
    const double c = std::cos(angle), s = std::sin(angle);
    const double a[3] = {axis.x / length, axis.y / length, axis.z / length};
    // Rodrigues: R = c I + (1 - c) a a^T + s [a]_x
    const double cross[3][3] = {{0, -a[2], a[1]}, {a[2], 0, -a[0]}, {-a[1], a[0], 0}};
    Transform r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            r.m[i][j] = float((i == j ? c : 0) + (1 - c) * a[i] * a[j] + s * cross[i][j]);
            r.mInv[j][i] = r.m[i][j];
        }
    return r;
}

std::optional<Transform> Transform::LookAt(Point3f eye, Point3f look, Vector3f up) {
    if (eye == look || !(LengthSquared(up) > 0)) return {};
    const Vector3f dir = Normalize(look - eye);
    const Vector3f side = Cross(Normalize(up), dir);
    if (!(Length(side) > 1e-6f)) return {};
    const Vector3f right = Normalize(side), newUp = Cross(dir, right);
    Matrix4 worldFromCamera{};
    for (int i = 0; i < 3; ++i)
        worldFromCamera[i] = {right[i], newUp[i], dir[i], eye[i]};
    worldFromCamera[3] = {0, 0, 0, 1};
    const std::optional<Transform> t = FromMatrix(worldFromCamera);
    if (!t) return {};
    return t->Inverse();
}

Transform Transform::Perspective(float fov, float near, float far) {
    const float s = 1 / std::tan(Radians(fov) / 2);
    const Matrix4 m{{{s, 0, 0, 0},
                     {0, s, 0, 0},
                     {0, 0, far / (far - near), -far * near / (far - near)},
                     {0, 0, 1, 0}}};
    return *FromMatrix(m);
}

Transform Transform::operator*(const Transform &b) const {
    return Transform(Product(m, b.m), Product(b.mInv, mInv));
}

bool Transform::SwapsHandedness() const {
    // In double, for a scale of 1e-16 is cubed.
    const auto column = [&](int i) { return Vec3<double>{m[0][i], m[1][i], m[2][i]}; };
    return Dot(Cross(column(0), column(1)), column(2)) < 0;
}

Bounds3f Transform::Bounds(const Bounds3f &b) const {
    Bounds3f r;
    for (int i = 0; i < 8; ++i)
        r.Grow(Point(
            {(i & 1 ? b.max : b.min).x, (i & 2 ? b.max : b.min).y, (i & 4 ? b.max : b.min).z}));
    return r;
}

}  // namespace pbrt
