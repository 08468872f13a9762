#pragma once

#include <optional>

#include "pbrt/shapes/bilinear.h"
#include "pbrt/shapes/intersect.h"
#include "pbrt/shapes/sample_common.h"
#include "pbrt/util/math.h"

namespace pbrt {

/// The rectangle [x0, x1] x [y0, y1] at height h > 0 over the origin, as seen from there. Sampled
/// by solid angle as in Urena, Fajardo, King 2013, with own closed forms: with c(x) = x /
/// hypot(x, h) and b_j = c(y_j) the solid angle up to x is G(x) - G(x0), G = asin(c b1) -
/// asin(c b0); its inverse is c = sin G / sqrt(b0^2 + b1^2 - 2 b0 b1 cos G).
struct SeenRectangle {
    float x0, x1, y0, y1, h;
    float g0, solidAngle;

    /// Less is drawn by area: G has an absolute error of 2e-7.
    static constexpr float kLeast = 0.01f;
    bool IsUsed() const { return solidAngle > kLeast; }

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
        return std::atan2(x * (y1 * hr0 - y0 * hr1), hr0 * hr1 + x * x * y0 * y1);
    }
};

/// One patch of a mesh as an emitter.
class BilinearSampler {
  public:
    BilinearSampler(const BilinearMesh &mesh, uint32_t primitive)
        : mesh(mesh), primitive(primitive), patch(GetPatch(mesh, primitive)) {}

    float Area() const;

    /// (u, v) with density proportional to the bilinear interpolation of the corners' area
    /// elements: uniform by area on flat patches, near it on others.
    std::optional<ShapeSample> SampleArea(Point2f u) const {
        const CornerAreas w(patch);
        if (!(w.sum > 0)) return {};
        const float v = SampleLinear(u.y, w.a00 + w.a10, w.a01 + w.a11);
        const Point2f uv{SampleLinear(u.x, Lerp(v, w.a00, w.a01), Lerp(v, w.a10, w.a11)), v};
        const float pdf = PDFArea(w, uv);
        if (!(pdf < Infinity)) return {};
        return At(uv, pdf);
    }

    std::optional<ShapeSample> SampleFrom(Point3f ref, Point2f u) const {
        if (const auto r = Rectangle(ref); r && r->IsUsed()) {
            const Point2f p = r->Sample(u);
            return At({(p.x - r->x0) / (r->x1 - r->x0), (p.y - r->y0) / (r->y1 - r->y0)},
                      1 / r->solidAngle);
        }
        return SeenFrom(SampleArea(u), ref);
    }

    float PDFFrom(Point3f ref, Point3f p, Normal3f n) const {
        if (const auto r = Rectangle(ref); r && r->IsUsed()) return 1 / r->solidAngle;
        const CornerAreas w(patch);
        const float pdfArea = mesh.planar ? 4 / w.sum : PDFArea(w, InvertPatch(patch, p, n));
        return PerSolidAngle(pdfArea, ref, p, n);
    }

    NormalCone Normals() const;

  private:
    /// Lengths of cross(dpdu, dpdv) at the corners.
    struct CornerAreas {
        float a00, a10, a01, a11, sum;
        explicit CornerAreas(const Patch &q)
            : a00(Length(Cross(q.p10 - q.p00, q.p01 - q.p00))),
              a10(Length(Cross(q.p10 - q.p00, q.p11 - q.p10))),
              a01(Length(Cross(q.p11 - q.p01, q.p01 - q.p00))),
              a11(Length(Cross(q.p11 - q.p01, q.p11 - q.p10))), sum(a00 + a10 + a01 + a11) {}
    };

    /// x in [0, 1) with density linear from a to b.
    static float SampleLinear(float u, float a, float b) {
        if (a == b) return u;
        return std::min(u * (a + b) / (a + std::sqrt(Lerp(u, a * a, b * b))), OneMinusEpsilon);
    }

    float PDFArea(const CornerAreas &w, Point2f uv) const {
        const float element = Length(Cross(patch.DpDu(uv.y), patch.DpDv(uv.x)));
        return 4 * BilinearWeights(uv)(w.a00, w.a10, w.a01, w.a11) / (w.sum * element);
    }

    /// The patch in a frame about ref, if it is a rectangle and ref not in its plane.
    std::optional<SeenRectangle> Rectangle(Point3f ref) const {
        const Vector3f e1 = patch.p10 - patch.p00, e2 = patch.p01 - patch.p00;
        const Vector3f skew = (patch.p11 - patch.p10) - e2;
        const float l1 = LengthSquared(e1), l2 = LengthSquared(e2);
        if (LengthSquared(skew) > 1e-12f * std::min(l1, l2)) return {};
        if (!(Sqr(Dot(e1, e2)) <= 1e-12f * l1 * l2)) return {};
        const float width = std::sqrt(l1), height = std::sqrt(l2);
        const Vector3f x = e1 * (1 / width), y = e2 * (1 / height), d = patch.p00 - ref;
        const float h = AbsDot(d, Cross(x, y));
        if (!(h > 0)) return {};
        const float x0 = Dot(d, x), y0 = Dot(d, y);
        return SeenRectangle(x0, x0 + width, y0, y0 + height, h);
    }

    ShapeSample At(Point2f uv, float pdf) const;

    const BilinearMesh &mesh;
    uint32_t primitive;
    Patch patch;
};

}  // namespace pbrt
