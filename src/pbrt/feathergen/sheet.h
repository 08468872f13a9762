#pragma once

#include <optional>
#include <vector>

#include "pbrt/feathergen/feather.h"

namespace pbrt::feathergen {

/// A feather as something that lies on others: points of its vane and its height over its plane.
/// Only the inner halves of the barbs count: the outer ones are soft, and lie between those of the
/// feathers at either side.
class Sheet {
  public:
    explicit Sheet(const Feather &feather);

    /// Points of rachis and rami above the first barb, the feather's own millimetres.
    const std::vector<Vec3d> &Points() const { return points; }
    /// Points on the rachis.
    const std::vector<Vec3d> &Spine() const { return spine; }
    /// Height of the vane's upper side at (x, y), where there is vane; too high by at most the
    /// bend over a cell.
    std::optional<double> Height(double x, double y) const;
    double Length() const { return length; }

  private:
    size_t CellIndex(int column, int row) const {
        return size_t(row) * size_t(columns) + size_t(column);
    }
    void Splat(Vec3d p);

    static constexpr double kEmpty = -1e30;
    std::vector<Vec3d> points, spine;
    double length, cell, x0, y0;
    int columns, rows;
    std::vector<double> heights;
};

}  // namespace pbrt::feathergen
