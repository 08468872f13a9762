#pragma once

#include <vector>

#include "pbrt/util/transform.h"

namespace pbrt {

/// The affine transform at time t in [0, 1] between two others: each is a translation after a
/// rotation after a stretch (polar decomposition: Shoemake, Duff 1992); the rotation turns evenly
/// about one axis by at most half a turn, the others are linear. nullopt where one of the two is
/// singular or only one of them mirrors.
std::optional<Transform> InterpolateMotion(const Transform &from, const Transform &to, float t);

/// Keys at equal steps of time, to be joined linearly by matrix entries, that keep within 1e-3 of
/// InterpolateMotion relative to lengths: as many as the turn needs, none where nothing turns.
std::vector<Transform> KeysBetween(const Transform &from, const Transform &to);

}  // namespace pbrt
