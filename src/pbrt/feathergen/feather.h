#pragma once

#include <cstdint>
#include <vector>

#include "pbrt/feathergen/bent_axis.h"
#include "pbrt/feathergen/parameters.h"

namespace pbrt::feathergen {

/// The side of a barb's ramus, looking from its root to its tip with the outer face up.
enum class Bank { Left, Right };

/// Parameters of the material at one place.
struct VaneValues {
    double thickness, spacing, tilt;
};

/// A point of a vane and its tangents along the barb (u) and across it (v, to the left). The outer
/// normal is along dpdu x dpdv.
struct VanePoint {
    Vec3d p, dpdu, dpdv;
    Vec3d Normal() const { return Normalize(Cross(dpdu, dpdv)); }
};

/// A ramus and its two banks, which lie on a cylinder along the ramus, the bulge up.
struct Barb {
    BentAxis axis;
    double place = 0;    ///< 0 the first barb of its side, 1 the last
    double width = 0;    ///< mm, of both banks together where it is widest
    double roll = 0;     ///< rad, about the axis, right side down
    VaneValues extra{};  ///< added to every value of this barb

    /// Width at u, of `width`.
    double Profile(const Parameters &p, double u) const;
    /// u in [0, 1] from root to tip, v in [-1, 1] from the right edge over the ramus to the left.
    VanePoint Surface(const Parameters &p, double u, double v) const;
    /// The same for any v: symmetric in v.
    VaneValues Values(const Parameters &p, double u, double v) const;
};

/// A feather in millimetres: root in the origin, rachis along +y at first, outer face to +z.
/// The same parameters and seed give the same feather, bit for bit.
struct Feather {
    Parameters parameters;
    BentAxis rachis;
    std::vector<Barb> barbs;  ///< from the base to the tip, right side and left in turns

    Feather(const Parameters &parameters, uint64_t seed);
    double RachisRadius(double u) const;
};

/// Degrees for the material's `rotation`: turns its y axis from the left of a barb to the barbules,
/// which stand at `span` to it; the right bank is the left one's mirror image.
double Rotation(const Parameters &parameters, Bank bank);

}  // namespace pbrt::feathergen
