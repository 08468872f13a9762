#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pbrt/feathergen/neck_surface.h"
#include "pbrt/feathergen/sheet.h"

namespace pbrt::feathergen {

/// Place, size and axes of one feather of a covering.
struct Placed {
    int kind;  ///< index into the sheets
    double scale;
    Vec3d root;
    Vec3d x, y, z;  ///< the feather's axes, unit

    Vec3d ToWorld(Vec3d p) const { return root + scale * (p.x * x + p.y * y + p.z * z); }
    Vec3d FromWorld(Vec3d p) const {
        const Vec3d d = (p - root) / scale;
        return {Dot(d, x), Dot(d, y), Dot(d, z)};
    }
};

/// Colors between green and purple; the sheets come color by color, p.neckShapes of each.
inline constexpr int kNeckColors = 4;

/// No covering has more feathers.
inline constexpr size_t kMostFeathers = 10000;

/// Covers the surface: roots no nearer to each other than neckSpacing (times the feather's size),
/// tips with the flow. Feathers are laid from the flow's end to its beginning, and each is turned
/// up at its root until it clears the surface and all that lie already: like shingles.
/// Nothing where more than kMostFeathers would be needed.
std::optional<std::vector<Placed>> Cover(std::span<const SurfaceSample> surface, Vec3d flow,
                                         const Parameters &p, std::span<const Sheet> sheets,
                                         uint64_t seed);

}  // namespace pbrt::feathergen
