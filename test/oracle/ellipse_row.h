#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/vector.h"

namespace pbrt::oracle {

/// An endless row of true ellipses in the plane across the barbules: barbule k has its centre at
/// x = k * spacing, a semi-axis `aspect` along its own normal, which is turned by `tilt` from z
/// towards x, and a semi-axis 1 across that.
///
/// Rays are met one ellipse at a time, by the quadratic equation of each. Barbules may
/// interpenetrate: light from outside meets the surface of their union only.
class EllipseRow {
  public:
    EllipseRow(double spacing, double tilt, double aspect)
        : spacing(spacing),
          aspect(aspect),
          shortAxis{std::sin(tilt), std::cos(tilt)},
          longAxis{std::cos(tilt), -std::sin(tilt)} {}

    double Spacing() const { return spacing; }

    struct Hit {
        double distance;  ///< along the ray, in lengths of its direction
        Vec2 point, normal;
        int barbule;
    };
    static constexpr int kNone = 1 << 30;

    /// The point of barbule 0 with eccentric angle e: aspect cos(e) along its own normal and sin(e)
    /// across that.
    Hit PointAt(double e) const {
        const Vec2 point = (aspect * std::cos(e)) * shortAxis + std::sin(e) * longAxis;
        return {0, point, Normal(point, 0), 0};
    }
    double EccentricAngle(Vec2 point, int barbule) const {
        const Vec2 c{point.x - barbule * spacing, point.z};
        return std::atan2(Dot(c, longAxis), Dot(c, shortAxis) / aspect);
    }
    /// Length of outline per radian of e.
    double Stretch(double e) const { return std::hypot(std::cos(e), aspect * std::sin(e)); }

    /// Whether a point of barbule 0 lies inside another one.
    bool Buried(Vec2 point) const {
        const int reach = int(2 * std::max(1.0, aspect) / spacing) + 1;
        for (int k = -reach; k <= reach; ++k) {
            const Vec2 c{point.x - k * spacing, point.z};
            if (k != 0 && std::hypot(Dot(c, shortAxis) / aspect, Dot(c, longAxis)) < 1) return true;
        }
        return false;
    }

    /// The first barbule that the ray o + s d meets at s > `from`, `except` apart.
    std::optional<Hit> FirstHit(Vec2 o, Vec2 d, double from, int except = kNone) const {
        double nearest = kNever;
        int found = kNone;
        ForEachOnLine(o, d, [&](int k) {
            const double s = k == except ? kNever : Entry(o, d, k);
            if (s > from && s < nearest) nearest = s, found = k;
            return true;
        });
        if (found == kNone) return {};
        const Vec2 point = o + nearest * d;
        return Hit{nearest, point, Normal(point, found), found};
    }

    /// Whether light from a point of the surface of barbule `from` gets away along d.
    bool Leaves(Vec2 point, int from, Vec2 d) const {
        bool free = true;
        ForEachOnLine(point, d, [&](int k) {
            const double s = k == from ? kNever : Entry(point, d, k);
            return free = s <= 0 || s == kNever;
        });
        return free;
    }

  private:
    static constexpr double kNever = 1e300;

    /// Where the line o + s d enters ellipse k; kNever if it passes by.
    double Entry(Vec2 o, Vec2 d, int k) const {
        const Vec2 c{o.x - k * spacing, o.z};
        const double ds = Dot(d, shortAxis) / aspect, dl = Dot(d, longAxis);
        const double cs = Dot(c, shortAxis) / aspect, cl = Dot(c, longAxis);
        const double square = ds * ds + dl * dl, cross = ds * cl - dl * cs;
        const double discriminant = square - cross * cross;  // (c.d)^2 - d^2 (c^2 - 1)
        if (discriminant <= 0) return kNever;
        return -(ds * cs + dl * cl + std::sqrt(discriminant)) / square;
    }

    Vec2 Normal(Vec2 point, int k) const {
        const Vec2 c{point.x - k * spacing, point.z};
        const Vec2 gradient =
            (Dot(c, shortAxis) / (aspect * aspect)) * shortAxis + Dot(c, longAxis) * longAxis;
        return (1 / std::hypot(gradient.x, gradient.z)) * gradient;
    }

    /// Visits the barbules that the line can meet until `visit` returns false, those nearest to o
    /// in number first.
    template <class Visit>
    void ForEachOnLine(Vec2 o, Vec2 d, const Visit &visit) const {
        const double length = std::hypot(d.x, d.z);
        if (length == 0) return;
        const Vec2 across{-d.z / length, d.x / length};
        const double shortPart = aspect * Dot(across, shortAxis);
        const double half = std::hypot(shortPart, Dot(across, longAxis));
        // A line along the row is cut off after a million barbules.
        const double step = spacing * std::max(std::abs(across.x), 1e-6 / spacing);
        const double middle = std::copysign(Dot(o, across) / step, across.x * Dot(o, across));
        const int lo = int(std::ceil(middle - half / step));
        const int hi = int(std::floor(middle + half / step));
        const int start = std::clamp(int(std::lround(o.x / spacing)), lo, std::max(lo, hi));
        for (int below = start - 1, above = start; below >= lo || above <= hi; --below, ++above) {
            if (above <= hi && !visit(above)) return;
            if (below >= lo && !visit(below)) return;
        }
    }

    double spacing, aspect;
    Vec2 shortAxis, longAxis;
};

}  // namespace pbrt::oracle
