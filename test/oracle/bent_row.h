#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/ellipse_row.h"
#include "oracle/vector.h"

namespace pbrt::oracle {

/// The row of barbules, bent along y: a cup whose section along y is a circular arc of half angle
/// `opening`, open towards +z, made of straight rows so short that each may be taken as endless in
/// itself (MODEL 4.3). Lengths along y are in radii of the arc, those across in half-widths of a
/// barbule.
///
/// For light from above all of this is geometry: the cup's mouth is lit evenly, a line meets the
/// arc where it does, and light that leaves a point of the arc must pass the mouth, so that rims
/// cast shadows. For light below the vane MODEL makes a choice, and so does this: a line belongs to
/// the same straight row whichever way it is travelled (geometry would have the cups' backs shadow
/// each other). Light through a gap is followed no further, as in MODEL (above an opening of about
/// 1 it could meet the next cup).
class BentRow {
  public:
    BentRow(double spacing, double tilt, double aspect, double opening)
        : row(spacing, tilt, aspect),
          sinOpening(std::sin(opening)),
          cosOpening(std::cos(opening)) {}

    /// A straight row of the chain, by its bend angle; its normal is (0, sin, cos).
    struct Segment {
        double sin, cos;
    };

    /// A point of the surface.
    struct Hit {
        Segment segment;
        Vec2 point;  ///< in the plane across the row
        int barbule;
        Vec3 normal;
    };

    /// The segment that light from w (pointing away, w.z != 0) meets if it crosses the mouth at
    /// share u of its width.
    Segment Lit(Vec3 w, double u) const {
        const Vec2 mouth{(2 * u - 1) * sinOpening, -cosOpening};  // (y, z) from the arc's centre
        const Vec2 down = w.z > 0 ? Vec2{-w.y, -w.z} : Vec2{w.y, w.z};
        const double square = Dot(down, down), half = Dot(mouth, down);
        const double under = (mouth.x - sinOpening) * (mouth.x + sinOpening);  // <= 0
        const double root = std::sqrt(half * half - square * under);
        const double s = half > 0 ? -under / (half + root) : (root - half) / square;
        const Vec2 met = mouth + s * down;
        return {-met.x, -met.z};
    }

    /// The point that the light from w meets if it crosses the mouth at share u0 of its width and
    /// the straight row there at share u1 of its period; none in a gap.
    std::optional<Hit> Enter(Vec3 w, double u0, double u1) const {
        return Meet(Lit(w, u0), -w, u1);
    }

    /// The point of a segment's surface, if it is one, with eccentric angle e.
    std::optional<Hit> At(Segment a, double e) const {
        const EllipseRow::Hit point = row.PointAt(e);
        if (row.Buried(point.point)) return {};
        return Surface(a, point);
    }
    double EccentricAngle(const Hit &h) const { return row.EccentricAngle(h.point, h.barbule); }

    /// Density of Enter's points for even u0 and u1, per radian of bend angle and of eccentric
    /// angle: the area of surface there, as w sees it.
    double HitDensity(Vec3 w, const Hit &h) const {
        const double cosine = Dot(w, h.normal);
        if (cosine <= 0 || !Leaves(h, w)) return 0;
        return row.Stretch(EccentricAngle(h)) * cosine /
               (row.Spacing() * 2 * sinOpening * std::abs(w.z));
    }

    /// Whether light that starts at a point of the surface along d is away without meeting it.
    bool Leaves(const Hit &from, Vec3 d) const {
        return FarPoint(from.segment, d).z >= -cosOpening &&
               row.Leaves(from.point, from.barbule, Across(from.segment, d));
    }

    /// Where light goes that starts at a surface point along d and does not leave: the same
    /// straight row, or another one of the cup, crossed at share u of its period. None if it passes
    /// out of the cup's back.
    std::optional<Hit> Next(const Hit &from, Vec3 d, double u) const {
        const Vec2 across = Across(from.segment, d);
        const auto hit = row.FirstHit(from.point, across, 0, from.barbule);
        if (hit) return Surface(from.segment, *hit);
        if (across.z < 0) return {};
        const Vec2 far = FarPoint(from.segment, d);
        return Meet({-far.x, -far.z}, d, u);
    }

  private:
    static Vec2 Across(Segment a, Vec3 d) { return {d.x, d.y * a.sin + d.z * a.cos}; }

    /// Where the line along d from a segment meets the arc's circle again.
    static Vec2 FarPoint(Segment a, Vec3 d) {
        const double square = d.y * d.y + d.z * d.z;
        const double s = square > 0 ? 2 * (d.y * a.sin + d.z * a.cos) / square : 0;
        return {s * d.y - a.sin, s * d.z - a.cos};
    }

    static Hit Surface(Segment a, const EllipseRow::Hit &h) {
        return {a, h.point, h.barbule, {h.normal.x, h.normal.z * a.sin, h.normal.z * a.cos}};
    }

    /// Light along d meets a straight row from outside.
    std::optional<Hit> Meet(Segment a, Vec3 d, double u) const {
        const auto hit = row.FirstHit({u * row.Spacing(), 0}, Across(a, d), -kFar);
        if (!hit) return {};
        return Surface(a, *hit);
    }

    static constexpr double kFar = 1e290;
    EllipseRow row;
    double sinOpening, cosOpening;
};

}  // namespace pbrt::oracle
