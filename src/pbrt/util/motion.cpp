#include "pbrt/util/motion.h"

#include <algorithm>
#include <cmath>

#include "pbrt/util/matrix.h"

namespace pbrt {
namespace {

/// Parts of an affine transform; `rotation` is proper, a mirroring is left to `stretch`.
struct Polar {
    Matrix3d rotation, stretch;
    std::array<double, 3> translation;
    bool mirrors;
};

/// Newton's iteration R <- (R + R^-T) / 2 ends at the nearest orthogonal matrix.
std::optional<Polar> Decompose(const Transform &t) {
    Polar p;
    Matrix3d m;
    double size = 0;
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            m[i][j] = t.Matrix()[i][j];
            size = std::max(size, std::abs(m[i][j]));
        }
        p.translation[i] = t.Matrix()[i][3];
    }
    if (!(size > 0)) return {};
    Matrix3d r = m;
    for (auto &row : r)
        for (double &v : row)
            v /= size;
    for (int step = 0; step < 100; ++step) {
        const double det = Determinant(r);
        if (!(std::abs(det) > 1e-30)) return {};
        double change = 0;
        Matrix3d next;
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) {
                next[i][j] = (r[i][j] + Cofactor(r, i, j) / det) / 2;
                change = std::max(change, std::abs(next[i][j] - r[i][j]));
            }
        r = next;
        if (change < 1e-14) break;
    }
    p.mirrors = Determinant(r) < 0;
    if (p.mirrors)
        for (auto &row : r)
            for (double &v : row)
                v = -v;
    p.rotation = r;
    p.stretch = Product(Transposed(r), m);
    return p;
}

struct AxisAngle {
    std::array<double, 3> axis;
    double angle;  ///< in [0, pi]
};

/// The axis from the matrix's symmetric part, which keeps its digits up to half a turn.
AxisAngle ToAxisAngle(const Matrix3d &r) {
    const double cosAngle = std::clamp((r[0][0] + r[1][1] + r[2][2] - 1) / 2, -1., 1.);
    const std::array<double, 3> twist{r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
    const double sinAngle = std::hypot(twist[0], twist[1], twist[2]) / 2;
    AxisAngle a{{0, 0, 1}, std::atan2(sinAngle, cosAngle)};
    if (cosAngle >= 0) {
        if (sinAngle > 1e-12)
            for (size_t i = 0; i < 3; ++i)
                a.axis[i] = twist[i] / (2 * sinAngle);
        return a;
    }
    // (R + R^T) / 2 = cos + (1 - cos) axis axis^T: its longest column, on the side of the twist.
    size_t k = 0;
    for (size_t i = 1; i < 3; ++i)
        if (r[i][i] > r[k][k]) k = i;
    double length = 0, side = 0;
    for (size_t i = 0; i < 3; ++i) {
        a.axis[i] = (r[i][k] + r[k][i]) / 2 - (i == k ? cosAngle : 0);
        length = std::hypot(length, a.axis[i]);
        side += a.axis[i] * twist[i];
    }
    for (double &v : a.axis)
        v /= side < 0 ? -length : length;
    return a;
}

Matrix3d Rotation(const AxisAngle &a, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto &[x, y, z] = a.axis;
    const Matrix3d cross{{{0, -z, y}, {z, 0, -x}, {-y, x, 0}}};
    Matrix3d r;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            r[i][j] = (i == j ? c : 0) + (1 - c) * a.axis[i] * a.axis[j] + s * cross[i][j];
    return r;
}

AxisAngle TurnBetween(const Polar &from, const Polar &to) {
    return ToAxisAngle(Product(to.rotation, Transposed(from.rotation)));
}

}  // namespace

std::optional<Transform> InterpolateMotion(const Transform &from, const Transform &to, float t) {
    const std::optional<Polar> a = Decompose(from), b = Decompose(to);
    if (!a || !b || a->mirrors != b->mirrors) return {};
    const AxisAngle turn = TurnBetween(*a, *b);
    Matrix3d stretch;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            stretch[i][j] = a->stretch[i][j] + t * (b->stretch[i][j] - a->stretch[i][j]);
    const Matrix3d r = Product(Rotation(turn, t * turn.angle), Product(a->rotation, stretch));
    Matrix4 m{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j)
            m[i][j] = float(r[i][j]);
        m[i][3] = float(a->translation[i] + t * (b->translation[i] - a->translation[i]));
    }
    m[3][3] = 1;
    return Transform::FromMatrix(m);
}

std::vector<Transform> KeysBetween(const Transform &from, const Transform &to) {
    // A chord of angle x misses its arc by x^2 / 8 of the radius.
    constexpr double kStep = 0.085;
    const std::optional<Polar> a = Decompose(from), b = Decompose(to);
    if (!a || !b || a->mirrors != b->mirrors) return {};
    const int steps = int(std::ceil(TurnBetween(*a, *b).angle / kStep - 1e-3));
    std::vector<Transform> keys;
    for (int i = 1; i < steps; ++i) {
        const auto key = InterpolateMotion(from, to, float(i) / float(steps));
        if (!key) return {};
        keys.push_back(*key);
    }
    return keys;
}

}  // namespace pbrt
