#pragma once

#include <array>
#include <cstddef>

namespace pbrt {

/// m[row][column], acting on column vectors.
template <typename T, std::size_t N>
using SquareMatrix = std::array<std::array<T, N>, N>;
using Matrix3 = SquareMatrix<float, 3>;
using Matrix3d = SquareMatrix<double, 3>;
using Matrix4 = SquareMatrix<float, 4>;

template <typename T>
std::array<T, 3> Mul(const SquareMatrix<T, 3> &m, const std::array<T, 3> &v) {
    std::array<T, 3> r;
    for (std::size_t i = 0; i < 3; ++i)
        r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return r;
}

/// a b, summed in double.
template <typename T, std::size_t N>
SquareMatrix<T, N> Product(const SquareMatrix<T, N> &a, const SquareMatrix<T, N> &b) {
    SquareMatrix<T, N> r;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < N; ++k)
                sum += double(a[i][k]) * b[k][j];
            r[i][j] = T(sum);
        }
    return r;
}

inline Matrix3 ToFloat(const Matrix3d &m) {
    Matrix3 r;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            r[i][j] = float(m[i][j]);
    return r;
}

template <typename T, std::size_t N>
SquareMatrix<T, N> Transposed(const SquareMatrix<T, N> &m) {
    SquareMatrix<T, N> t;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j)
            t[i][j] = m[j][i];
    return t;
}

/// Element (i, j) of the matrix of cofactors, which is the inverse's transpose times the
/// determinant.
inline double Cofactor(const Matrix3d &m, std::size_t i, std::size_t j) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
}

inline double Determinant(const Matrix3d &m) {
    return m[0][0] * Cofactor(m, 0, 0) + m[0][1] * Cofactor(m, 0, 1) + m[0][2] * Cofactor(m, 0, 2);
}

/// Inverse of a matrix that has one.
inline Matrix3d Inverse(const Matrix3d &m) {
    const double determinant = Determinant(m);
    Matrix3d r;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            r[i][j] = Cofactor(m, j, i) / determinant;
    return r;
}

}  // namespace pbrt
