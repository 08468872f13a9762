#pragma once

#include <algorithm>
#include <optional>

#include "pbrt/shapes/bilinear.h"
#include "pbrt/util/atan2.h"
#include "pbrt/util/math.h"

namespace pbrt {

/// The rectangle [x0, x1] x [y0, y1] at height h > 0 over the origin, as seen from there. Sampled
/// by solid angle as in Urena, Fajardo, King 2013, with own closed forms: with c(x) = x /
/// hypot(x, h) and b_j = c(y_j) the solid angle up to x is G(x) - G(x0), G = asin(c b1) -
/// asin(c b0); its inverse is c = sin G / sqrt(b0^2 + b1^2 - 2 b0 b1 cos G).
struct SeenRectangle {
    float x0, x1, y0, y1, h;
    float g0, solidAngle;

    SeenRectangle(float x0, float x1, float y0, float y1, float h)
        : x0(x0), x1(x1), y0(y0), y1(y1), h(h), g0(G(x0)), solidAngle(G(x1) - g0) {}

    Point2f Sample(Point2f u) const {
        const float b0 = y0 / std::sqrt(y0 * y0 + h * h), b1 = y1 / std::sqrt(y1 * y1 + h * h);
        const SinCos half = SinCosTurns((u.x * solidAngle + g0) * (InvPi / 4));
        const float square = Sqr(b1 - b0) + 4 * b0 * b1 * Sqr(half.sin);
        const float c = std::clamp(2 * half.sin * half.cos / SafeSqrt(square), -1.f, 1.f);
        const float x = std::clamp(c * h / SafeSqrt(1 - c * c), x0, x1);
        // On the line of this x the density of s = y / distance is constant.
        const float d2 = x * x + h * h;
        const float s0 = y0 / std::sqrt(d2 + y0 * y0), s1 = y1 / std::sqrt(d2 + y1 * y1);
        const float s = Lerp(u.y, s0, s1);
        return {x, std::clamp(s * std::sqrt(d2 / std::max(1 - s * s, 1e-12f)), y0, y1)};
    }

  private:
    float G(float x) const {
        const float d2 = x * x + h * h;
        const float hr0 = h * std::sqrt(d2 + y0 * y0), hr1 = h * std::sqrt(d2 + y1 * y1);
        return FastAtan2(x * (y1 * hr0 - y0 * hr1), hr0 * hr1 + x * x * y0 * y1);
    }
};

/// A flat rectangular emitter with everything that does not depend on the receiver worked out.
///
/// Directions are drawn by solid angle where the rectangle looks large (more than about 0.25 sr) or
/// reaches from near to far, else by area: there the density per solid angle varies little, and
/// costs a fourth.
class Rectangle {
  public:
    struct Sample {
        Point3f p;
        Point2f uv;
        float pdf;  ///< per unit solid angle
    };

    /// From a mesh of one rectangular, flat patch.
    static std::optional<Rectangle> From(const BilinearMesh &mesh) {
        if (mesh.NPrimitives() != 1 || !mesh.planar || !mesh.n.empty() || !mesh.uv.empty())
            return {};
        auto r = From(GetPatch(mesh, 0));
        if (r && mesh.flipNormal) r->n = -r->n;
        return r;
    }
    /// From a patch that is a rectangle up to 1e-5 of its sides.
    static std::optional<Rectangle> From(const Patch &patch) {
        const Vector3f e1 = patch.p10 - patch.p00, e2 = patch.p01 - patch.p00;
        const float w2 = LengthSquared(e1), h2 = LengthSquared(e2);
        const Vector3f skew = patch.p11 - patch.p10 - e2;
        if (!(w2 > 0 && h2 > 0) || LengthSquared(skew) > 1e-10f * std::min(w2, h2) ||
            Sqr(Dot(e1, e2)) > 1e-10f * w2 * h2)
            return {};
        Rectangle r;
        r.corner = patch.p00;
        r.width = std::sqrt(w2), r.height = std::sqrt(h2);
        r.x = e1 * (1 / r.width), r.y = e2 * (1 / r.height);
        r.n = Normalize(Cross(r.x, r.y));
        r.pError = Gamma(8) * (Abs(r.corner) + Abs(e1) + Abs(e2));
        return r;
    }

    Normal3f Normal() const { return n; }
    Vector3f Error() const { return pError; }

    std::optional<Sample> SampleFrom(Point3f ref, Point2f u) const {
        const View v(*this, ref);
        if (!(v.h > 0)) return {};
        if (const auto seen = v.BySolidAngle(*this)) {
            const Point2f q = seen->Sample(u);
            const float a = q.x - v.x0, b = q.y - v.y0;
            return Sample{corner + a * x + b * y, {a / width, b / height}, 1 / seen->solidAngle};
        }
        const float a = u.x * width, b = u.y * height;
        const float d2 = Sqr(v.x0 + a) + Sqr(v.y0 + b) + Sqr(v.h);
        return Sample{corner + a * x + b * y, u, d2 * std::sqrt(d2) / (v.h * width * height)};
    }
    /// Density of SampleFrom for the point p of the rectangle.
    float PDFFrom(Point3f ref, Point3f p) const {
        const View v(*this, ref);
        if (!(v.h > 0)) return 0;
        if (const auto seen = v.BySolidAngle(*this)) return 1 / seen->solidAngle;
        const float d2 = DistanceSquared(p, ref);
        return d2 * std::sqrt(d2) / (v.h * width * height);
    }

  private:
    /// The rectangle is [x0, x0 + width] x [y0, y0 + height] at height h over the receiver.
    struct View {
        float x0, y0, h;
        View(const Rectangle &r, Point3f ref) {
            const Vector3f d = r.corner - ref;
            x0 = Dot(d, r.x), y0 = Dot(d, r.y), h = AbsDot(d, r.n);
        }
        std::optional<SeenRectangle> BySolidAngle(const Rectangle &r) const {
            // Area times cosine over squared distance of the middle: about the solid angle.
            const float d2 = Sqr(x0 + r.width / 2) + Sqr(y0 + r.height / 2) + Sqr(h);
            const float most = 0.25f * d2;
            if (Sqr(r.width * r.height * h) < most * most * d2 && Sqr(r.width) + Sqr(r.height) < d2)
                return {};
            const SeenRectangle seen(x0, x0 + r.width, y0, y0 + r.height, h);
            // Thin strips: the solid angle's absolute error of 2e-7 must not show.
            if (!(seen.solidAngle > 0.01f)) return {};
            return seen;
        }
    };

    Point3f corner;
    Vector3f x, y, pError;
    Normal3f n;
    float width = 0, height = 0;
};

}  // namespace pbrt
