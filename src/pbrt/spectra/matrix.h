#pragma once

#include <array>

namespace pbrt {

using Triple = std::array<double, 3>;
/// Colour conversions in double, [row][column]; the float ones users see are rounded from these.
using Matrix3d = std::array<Triple, 3>;

inline Triple Mul(const Matrix3d &m, const Triple &v) {
    Triple r;
    for (int i = 0; i < 3; ++i)
        r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return r;
}

inline Matrix3d Mul(const Matrix3d &a, const Matrix3d &b) {
    Matrix3d r{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                r[i][j] += a[i][k] * b[k][j];
    return r;
}

/// Inverse by cofactors, of a matrix that has one.
inline Matrix3d Inverse(const Matrix3d &m) {
    Matrix3d r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            r[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    const double determinant = m[0][0] * r[0][0] + m[0][1] * r[1][0] + m[0][2] * r[2][0];
    for (Triple &row : r)
        for (double &v : row)
            v /= determinant;
    return r;
}

}  // namespace pbrt
