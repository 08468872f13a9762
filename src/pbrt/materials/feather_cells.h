#pragma once

#include <cstdint>

#include "pbrt/base/texture.h"

namespace pbrt {

class ParamDict;

/// How a cell of a vane differs from the mean, in standard deviations: numbers of mean 0 and
/// variance 1 that no cell shares with another, each below 3.4641 in size.
struct FeatherCell {
    float thickness = 0, tilt = 0, bend = 0;
};

/// Cells of a feather's vane, one barbule wide and some 25 um long: a grid over the surface's uv
/// (MODEL section 11). Each cell's numbers are a hash of its place; nothing is stored.
class FeatherCells {
  public:
    FeatherCells() = default;
    static FeatherCells Create(ParamDict &params);

    /// False where the grid is not given: then there is but one cell, of mean values.
    explicit operator bool() const { return across > 0 && along > 0; }
    /// The cell that a point lies in: the same for the same uv and face, whoever asks.
    FeatherCell At(const TextureEvalContext &ctx) const;
    /// The cell in column i and row j of a face; `seed` tells grids apart.
    static FeatherCell Of(int64_t i, int64_t j, int face, int seed);

  private:
    float across = 0, along = 0;  ///< cells for one unit of u and of v
    float shear = 0;              ///< u that one unit of v is worth
    bool perFace = false;
    int seed = 0;
};

}  // namespace pbrt
