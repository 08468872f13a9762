#pragma once

#include <concepts>

#include "bend.h"
#include "direction.h"
#include "gap.h"
#include "params.h"
#include "row.h"

namespace pbrt::feather {

/// A patch of vane without its film: what does not change with the wavelength.
template <std::floating_point T>
struct Vane {
    Row<T> row;
    Bend<T> bend;

    /// `params` within kParams' ranges.
    explicit Vane(const BarbuleParams<T> &params)
        : row(params.spacing, params.tilt, params.aspect), bend(params.opening) {}

    /// Share of light from w that passes straight through, T(w) = T(-w), in [0, 1].
    T GapFraction(Direction<T> w) const {
        return Grazing(w) ? T(0) : feather::GapFraction(row, bend, w);
    }
};

}  // namespace pbrt::feather
