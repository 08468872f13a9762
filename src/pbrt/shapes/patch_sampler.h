#pragma once

#include <optional>

#include "pbrt/shapes/bilinear_mesh.h"
#include "pbrt/shapes/patch_intersection.h"
#include "pbrt/shapes/rectangle.h"
#include "pbrt/shapes/solid_angle.h"

namespace pbrt {

/// One patch of a mesh as an emitter.
class PatchSampler {
  public:
    PatchSampler(const BilinearMesh &mesh, uint32_t primitive)
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
        if (const auto rectangle = Rectangle::From(patch)) {
            const Rectangle::Sample drawn = rectangle->SampleFrom(ref, u);
            if (!(drawn.pdf > 0)) return {};
            return At(drawn.uv, drawn.pdf);
        }
        return SeenFrom(SampleArea(u), ref);
    }

    float PDFFrom(Point3f ref, Point3f p, Normal3f n) const {
        if (const auto rectangle = Rectangle::From(patch)) return rectangle->PDFFrom(ref, p);
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
              a11(Length(Cross(q.p11 - q.p01, q.p11 - q.p10))),
              sum(a00 + a10 + a01 + a11) {}
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

    ShapeSample At(Point2f uv, float pdf) const;

    const BilinearMesh &mesh;
    uint32_t primitive;
    Patch patch;
};

}  // namespace pbrt
