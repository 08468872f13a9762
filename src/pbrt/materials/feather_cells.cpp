#include "pbrt/materials/feather_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pbrt/feather/params.h"
#include "pbrt/materials/feather_rows.h"
#include "pbrt/scene/params.h"
#include "pbrt/util/hash.h"

namespace pbrt {
namespace {

constexpr BoolParam kPerFace{"cellsperface", false,
                             "the grid begins anew in each face, as uv of Ptex do"};
constexpr IntParam kSeed{"cellseed", 0, kLeastInt, kMostInt,
                         "tells the cells of one material from those of another"};

/// A sum of four uniform numbers, nearly normal: mean 0, variance 1 to 1e-9.
float Bell(uint64_t bits) {
    const uint64_t sum =
        (bits & 0xffff) + (bits >> 16 & 0xffff) + (bits >> 32 & 0xffff) + (bits >> 48);
    return std::numbers::sqrt3_v<float> * (float(int64_t(sum) + 2) * 0x1p-16f - 2);
}

/// Places that an integer holds; what is no number, and so no place, is the first.
int64_t Floor(float place) {
    constexpr float most = 0x1p62f;
    return int64_t(std::floor(std::clamp(place == place ? place : -most, -most, most)));
}

}  // namespace

FeatherCells FeatherCells::Create(ParamDict &params) {
    FeatherCells cells;
    const auto read = [&](int i) { return params.GetOneFloat(RowOf(feather::kCellParams[i])); };
    cells.across = read(0);
    cells.along = read(1);
    cells.shear = read(2);
    cells.perFace = params.GetOneBool(kPerFace);
    cells.seed = params.GetOneInt(kSeed);
    return cells;
}

FeatherCell FeatherCells::At(const TextureEvalContext &ctx) const {
    const int64_t i = Floor(across * (ctx.uv.x + shear * ctx.uv.y)), j = Floor(along * ctx.uv.y);
    return Of(i, j, perFace ? ctx.faceIndex : 0, seed);
}

FeatherCell FeatherCells::Of(int64_t i, int64_t j, int face, int seed) {
    const uint64_t h = Hash(i, j, face, seed);
    const auto number = [h](uint64_t k) { return Bell(Mix64(h + k * kGolden64)); };
    return {number(1), number(2), number(3)};
}

}  // namespace pbrt
