#pragma once

#include <vector>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// True where the points, a power of two of them, are a (0,m,2)-net: each box of the grids of
/// 2^a x 2^(m-a) boxes holds exactly one.
inline bool IsNet(const std::vector<Point2f> &points) {
    const size_t n = points.size();
    for (size_t nx = 1; nx <= n; nx *= 2) {
        const size_t ny = n / nx;
        std::vector<bool> full(n);
        for (Point2f p : points) {
            const size_t box = size_t(p.y * float(ny)) * nx + size_t(p.x * float(nx));
            if (full[box]) return false;
            full[box] = true;
        }
    }
    return true;
}

}  // namespace pbrt
