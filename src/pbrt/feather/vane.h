#pragma once

#include <concepts>

#include "bend.h"
#include "direction.h"
#include "fields.h"
#include "gap.h"
#include "params.h"
#include "row.h"

namespace pbrt::feather {

/// A patch of vane without its film: what does not change with the wavelength.
template <class V>
struct Vane {
    Row<V> row;
    Bend<V> bend;

    Vane() = default;
    /// `params` within kParams' ranges.
    explicit Vane(const BarbuleParams<ScalarOf<V>> &params) requires std::floating_point<V>
        : row(params.spacing, params.tilt, params.aspect), bend(params.opening) {}

    /// V of sixteen: element k becomes a copy of `one`.
    void Set(int k, const Vane<ScalarOf<V>> &one) {
        SetFields(k, row.Fields(), one.row.Fields());
        SetFields(k, bend.Fields(), one.bend.Fields());
    }

    /// Share of light from w that passes straight through, T(w) = T(-w), in [0, 1].
    V GapFraction(Direction<V> w) const {
        return Grazing(w) ? V(0) : feather::GapFraction(row, bend, w);
    }
};

}  // namespace pbrt::feather
