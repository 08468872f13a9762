#pragma once

#include <cmath>

#include "pbrt/feathergen/feather.h"

namespace pbrt::feathergen {

/// Division of a feather's vane into quads, and their numbers: every barb has two banks, a
/// bank nAcross rows of nAlong quads. Row 0 lies at v = 0 of a left bank, at v = -1 of a right one,
/// so that in both u runs to the barb's tip, v to its left and the outer face is theirs.
struct VaneGrid {
    int nBarbs, nAlong, nAcross;

    explicit VaneGrid(const Feather &feather)
        : nBarbs(int(feather.barbs.size())),
          nAlong(int(feather.parameters.quadsAlong)),
          nAcross(int(feather.parameters.quadsAcross)) {}

    int NBanks() const { return 2 * nBarbs; }
    int BankIndex(int barb, Bank bank) const { return 2 * barb + (bank == Bank::Right ? 1 : 0); }
    int NFaces() const { return NBanks() * nAcross * nAlong; }
    int Face(int bankIndex, int along, int across) const {
        return (bankIndex * nAcross + across) * nAlong + along;
    }
    double U(double along) const { return along / nAlong; }
    /// Rows are narrow near the ramus, where the tilt changes.
    double V(Bank bank, double across) const {
        const double x = across / nAcross;
        return bank == Bank::Left ? std::pow(x, 1.5) : -std::pow(1 - x, 1.5);
    }

    // The atlas: a column of texels for each quad along; each bank's rows repeat the outermost ones
    // above and below, so that bilinear look-ups stay within the bank.
    int AtlasRows() const { return NBanks() * (nAcross + 2); }
    int AtlasRow(int bankIndex, int across) const { return bankIndex * (nAcross + 2) + 1 + across; }
};

}  // namespace pbrt::feathergen
