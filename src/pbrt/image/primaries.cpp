#include "pbrt/image/primaries.h"

#include <cmath>

#include "pbrt/util/vecmath.h"

namespace pbrt {
namespace {

using Vector3d = Vec3<double>;
using Columns = std::array<Vector3d, 3>;

/// Rows of the inverse of the matrix with these columns.
std::optional<Columns> InverseRows(const Columns &c) {
    const double determinant = Dot(Cross(c[0], c[1]), c[2]);
    if (!(std::abs(determinant) > 1e-9) || !std::isfinite(determinant)) return {};
    const double s = 1 / determinant;
    return Columns{s * Cross(c[1], c[2]), s * Cross(c[2], c[0]), s * Cross(c[0], c[1])};
}

/// At X + Y + Z = 1, since a primary's y may be 0.
Vector3d XYZOf(const std::array<float, 2> &xy) {
    return {xy[0], xy[1], 1 - double(xy[0]) - xy[1]};
}

/// Columns of XYZ from RGB: the primaries scaled so that their sum is the white of Y = 1.
std::optional<Columns> XYZFromRGB(const Chromaticities &xy) {
    Columns columns{XYZOf(xy[0]), XYZOf(xy[1]), XYZOf(xy[2])};
    const std::optional<Columns> inverse = InverseRows(columns);
    const double whiteY = xy[3][1];
    if (!inverse || !(std::abs(whiteY) > 1e-6)) return {};
    const Vector3d white = XYZOf(xy[3]) / whiteY;
    for (int i = 0; i < 3; ++i)
        columns[i] = Dot((*inverse)[i], white) * columns[i];
    return columns;
}

}  // namespace

bool SamePrimaries(const Chromaticities &a, const Chromaticities &b) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 2; ++j)
            if (!(std::abs(a[i][j] - b[i][j]) <= 1e-4f)) return false;
    return true;
}

std::optional<std::array<std::array<float, 3>, 3>> RGBFromRGB(const Chromaticities &to,
                                                              const Chromaticities &from) {
    const std::optional<Columns> xyzFromRGB = XYZFromRGB(from), xyzFromTarget = XYZFromRGB(to);
    if (!xyzFromRGB || !xyzFromTarget) return {};
    const std::optional<Columns> rows = InverseRows(*xyzFromTarget);
    if (!rows) return {};
    std::array<std::array<float, 3>, 3> m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            m[i][j] = float(Dot((*rows)[i], (*xyzFromRGB)[j]));
    return m;
}

}  // namespace pbrt
