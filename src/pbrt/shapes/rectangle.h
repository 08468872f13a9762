#pragma once

#include <optional>

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/types.h"
#include "pbrt/util/math.h"

namespace pbrt {

/// A flat rectangular emitter with everything that does not depend on the receiver worked out.
///
/// Directions are drawn by solid angle (Urena, Fajardo, King 2013) where the rectangle looks large
/// (more than about 0.25 sr), else by area: there the density per solid angle varies by a few per
/// cent only and costs a fourth.
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
        const uint32_t *i = mesh.indices.data();
        const Point3f p00 = mesh.p[i[0]], p10 = mesh.p[i[1]], p01 = mesh.p[i[2]];
        const Vector3f e1 = p10 - p00, e2 = p01 - p00;
        const float w2 = LengthSquared(e1), h2 = LengthSquared(e2);
        const Vector3f skew = mesh.p[i[3]] - p10 - e2;
        if (!(w2 > 0 && h2 > 0) || LengthSquared(skew) > 1e-10f * std::min(w2, h2) ||
            Sqr(Dot(e1, e2)) > 1e-10f * w2 * h2)
            return {};
        Rectangle r;
        r.corner = p00;
        r.width = std::sqrt(w2), r.height = std::sqrt(h2);
        r.x = e1 * (1 / r.width), r.y = e2 * (1 / r.height);
        r.n = Normalize(Cross(e1, e2)) * (mesh.flipNormal ? -1.f : 1.f);
        r.pError = Gamma(8) * (Abs(p00) + Abs(e1) + Abs(e2));
        return r;
    }

    Normal3f Normal() const { return n; }
    Vector3f Error() const { return pError; }

    std::optional<Sample> SampleFrom(Point3f ref, Point2f u) const {
        const View v(*this, ref);
        if (!(v.h > 0)) return {};
        if (v.Small(*this)) {
            const float a = u.x * width, b = u.y * height;
            const float d2 = Sqr(v.x0 + a) + Sqr(v.y0 + b) + Sqr(v.h);
            return Sample{corner + a * x + b * y, u, d2 * std::sqrt(d2) / (v.h * width * height)};
        }
        const SolidAngle s(v, *this);
        const Point2f q = s.Draw(v, *this, u);
        return Sample{corner + (q.x - v.x0) * x + (q.y - v.y0) * y,
                      {(q.x - v.x0) / width, (q.y - v.y0) / height},
                      1 / s.omega};
    }
    /// Density of SampleFrom for the point p of the rectangle.
    float PDFFrom(Point3f ref, Point3f p) const {
        const View v(*this, ref);
        if (!(v.h > 0)) return 0;
        if (!v.Small(*this)) return 1 / SolidAngle(v, *this).omega;
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
        /// Area times cosine over squared distance of the middle: about the solid angle.
        bool Small(const Rectangle &r) const {
            const float d2 = Sqr(x0 + r.width / 2) + Sqr(y0 + r.height / 2) + Sqr(h);
            const float most = 0.25f * d2;
            return Sqr(r.width * r.height * h) < most * most * d2;
        }
    };

    /// With A(x, y) = atan(x y / (h distance)) the solid angle up to x is G(x) - G(x0),
    /// G(x) = A(x, y1) - A(x, y0); with b_j = y_j / hypot(y_j, h) it is inverted by
    /// x / hypot(x, h) = sin G / sqrt(b0^2 + b1^2 - 2 b0 b1 cos G).
    struct SolidAngle {
        float g0, omega;

        SolidAngle(const View &v, const Rectangle &r) {
            using Lanes = float __attribute__((vector_size(16)));
            const float x1 = v.x0 + r.width, y1 = v.y0 + r.height;
            const Lanes px{v.x0, x1, v.x0, x1}, py{v.y0, v.y0, y1, y1};
            const Lanes d2 = px * px + py * py + v.h * v.h;
            Lanes a;
            for (int i = 0; i < 4; ++i) a[i] = std::atan2(px[i] * py[i], v.h * std::sqrt(d2[i]));
            g0 = a[2] - a[0];
            omega = (a[3] - a[1]) - g0;
        }
        Point2f Draw(const View &v, const Rectangle &r, Point2f u) const {
            const float y1 = v.y0 + r.height, h = v.h;
            const float b0 = v.y0 / std::sqrt(v.y0 * v.y0 + h * h);
            const float b1 = y1 / std::sqrt(y1 * y1 + h * h);
            const SinCos half = SinCosTurns((u.x * omega + g0) * (InvPi / 4));
            const float square = Sqr(b1 - b0) + 4 * b0 * b1 * Sqr(half.sin);
            const float c = std::clamp(2 * half.sin * half.cos / SafeSqrt(square), -1.f, 1.f);
            const float qx = std::clamp(c * h / SafeSqrt(1 - c * c), v.x0, v.x0 + r.width);
            // On the line of this x the density of s = y / distance is constant.
            const float d2 = qx * qx + h * h;
            const float s0 = v.y0 / std::sqrt(d2 + v.y0 * v.y0), s1 = y1 / std::sqrt(d2 + y1 * y1);
            const float s = Lerp(u.y, s0, s1);
            return {qx, std::clamp(s * std::sqrt(d2 / std::max(1 - s * s, 1e-12f)), v.y0, y1)};
        }
    };

    Point3f corner;
    Vector3f x, y, pError;
    Normal3f n;
    float width = 0, height = 0;
};

}  // namespace pbrt
