#pragma once

#include "pbrt/feather/params.h"
#include "pbrt/scene/param_row.h"

namespace pbrt {

/// A row of the feather model's tables as one of the scene language.
constexpr FloatParam RowOf(const feather::FloatParam &p) {
    return {p.name, feather::UnitName(p.unit), float(p.def), float(p.lo), float(p.hi), p.doc};
}

}  // namespace pbrt
