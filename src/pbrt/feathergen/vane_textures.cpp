#include "pbrt/feathergen/vane_textures.h"

#include <algorithm>
#include <numbers>

#include "pbrt/feathergen/vane_grid.h"

namespace pbrt::feathergen {
namespace {

VaneValues QuadMean(const Feather &feather, const VaneGrid &grid, int barb, Bank bank, int along,
                    int across) {
    constexpr int kSteps = 8;
    VaneValues mean{};
    for (int k = 0; k < kSteps; ++k) {
        const double v = Lerp((k + 0.5) / kSteps, grid.V(bank, across), grid.V(bank, across + 1));
        const VaneValues values =
            feather.barbs[size_t(barb)].Values(feather.parameters, grid.U(along + 0.5), v);
        mean.thickness += values.thickness / kSteps;
        mean.spacing += values.spacing / kSteps;
        mean.tilt += values.tilt / kSteps;
    }
    return mean;
}

}  // namespace

VaneTextures::VaneTextures(const Feather &feather) {
    const VaneGrid grid(feather);
    for (int b = 0; b < grid.nBarbs; ++b)
        for (const Bank bank : {Bank::Left, Bank::Right})
            for (int j = 0; j < grid.nAcross; ++j)
                for (int i = 0; i < grid.nAlong; ++i) {
                    const VaneValues mean = QuadMean(feather, grid, b, bank, i, j);
                    thickness.push_back(float(mean.thickness));
                    spacing.push_back(float(mean.spacing));
                    tilt.push_back(float(mean.tilt / std::numbers::pi + 0.5));
                }
}

Image Atlas(const Feather &feather, const std::vector<float> &values) {
    const VaneGrid grid(feather);
    const int rows = grid.AtlasRows();
    Image image({grid.nAlong, rows}, {"Y"});
    for (int bank = 0; bank < grid.NBanks(); ++bank)
        for (int j = -1; j <= grid.nAcross; ++j) {
            const int row = rows - 1 - grid.AtlasRow(bank, j);
            const int from = std::clamp(j, 0, grid.nAcross - 1);
            for (int i = 0; i < grid.nAlong; ++i)
                image.Set({i, row}, 0, values[size_t(grid.Face(bank, i, from))]);
        }
    return image;
}

PtexContent Faces(const Feather &feather, const std::vector<float> &values) {
    const VaneGrid grid(feather);
    PtexContent content = ConstantPtex(1, values);
    for (int bank = 0; bank < grid.NBanks(); ++bank) {
        const bool isLeft = bank % 2 == 0;
        // Across the ramus: a left bank's row 0 meets the last row of the right one.
        const int below = isLeft ? bank + 1 : -1, above = isLeft ? -1 : bank - 1;
        const auto face = [&](int at, int i, int j) {
            const bool isThere = at >= 0 && i >= 0 && i < grid.nAlong;
            return isThere ? grid.Face(at, i, j) : -1;
        };
        for (int j = 0; j < grid.nAcross; ++j)
            for (int i = 0; i < grid.nAlong; ++i) {
                PtexFace &f = content.faces[size_t(grid.Face(bank, i, j))];
                f.neighbours = {j > 0 ? face(bank, i, j - 1) : face(below, i, grid.nAcross - 1),
                                face(bank, i + 1, j),
                                j + 1 < grid.nAcross ? face(bank, i, j + 1) : face(above, i, 0),
                                face(bank, i - 1, j)};
                f.neighbourEdges = {2, 3, 0, 1};
            }
    }
    return content;
}

}  // namespace pbrt::feathergen
