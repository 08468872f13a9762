// Shapes as emitters: one dispatch per call; the work is in sample_*.h.

#include "pbrt/shapes/sample_bilinear.h"
#include "pbrt/shapes/sample_quadric.h"
#include "pbrt/shapes/sample_triangle.h"
#include "pbrt/shapes/shape.h"
#include "pbrt/util/check.h"

namespace pbrt {

float Volume(const Transform &t) {
    const Matrix4 &m = t.Matrix();
    return AbsDot(Cross(Vector3f{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}),
                  Vector3f{m[0][2], m[1][2], m[2][2]});
}

namespace {

/// Mean stretch of a surface of revolution's area, by the midpoint rule over its parameters.
template <typename Q>
float MeanStretch(const Q &quadric, int nU, int nV) {
    double sum = 0;
    for (int i = 0; i < nU; ++i)
        for (int j = 0; j < nV; ++j) {
            const ShapeSample s = SampleQuadric(quadric, {(i + 0.5f) / nU, (j + 0.5f) / nV});
            sum += 1 / (s.pdf * ObjectArea(quadric));
        }
    return float(sum / (nU * nV));
}

float QuadricArea(const Sphere &s) {
    const float scale = UniformScale(s.renderFromObject);
    return ObjectArea(s) * (scale > 0 ? Sqr(scale) : MeanStretch(s, 128, 128));
}
float QuadricArea(const Disk &d) {
    return ObjectArea(d) * AreaStretch(d.renderFromObject, {0, 0, 1});
}
float QuadricArea(const Cylinder &c) {
    return ObjectArea(c) * MeanStretch(c, 256, 1);
}

std::optional<ShapeSample> SampleQuadricFrom(const Sphere &s, Point3f ref, Point2f u) {
    if (const auto seen = SeenSphere::From(s, ref)) return seen->Sample(s, ref, u);
    return SeenFrom(SampleQuadric(s, u), ref);
}
template <typename Q>
std::optional<ShapeSample> SampleQuadricFrom(const Q &quadric, Point3f ref, Point2f u) {
    return SeenFrom(SampleQuadric(quadric, u), ref);
}

float QuadricPDFFrom(const Sphere &s, Point3f ref, Point3f p, Normal3f n) {
    if (const auto seen = SeenSphere::From(s, ref)) return seen->PDF();
    return PerSolidAngle(QuadricPDFArea(s, n), ref, p, n);
}
template <typename Q>
float QuadricPDFFrom(const Q &quadric, Point3f ref, Point3f p, Normal3f n) {
    return PerSolidAngle(QuadricPDFArea(quadric, n), ref, p, n);
}

NormalCone QuadricNormals(const Disk &d) {
    const Normal3f n = Normalize(d.renderFromObject.Normal({0, 0, 1}));
    return {d.flipNormal ? -n : n, 1};
}
template <typename Q>
NormalCone QuadricNormals(const Q &) {
    return {{0, 0, 1}, -1};
}

/// Calls f with a TriangleSampler, a BilinearSampler or a quadric; triangles first.
template <typename Mesh, typename Quadric>
auto Visit(const Shape &shape, uint32_t primitive, Mesh mesh, Quadric quadric) {
    switch (shape.index()) {
        case 0:
            return mesh(TriangleSampler(*std::get_if<0>(&shape), primitive));
        case 1:
            return mesh(BilinearSampler(*std::get_if<1>(&shape), primitive));
        case 2:
            return quadric(*std::get_if<2>(&shape));
        case 3:
            return quadric(*std::get_if<3>(&shape));
        default:
            DCHECK(CanEmit(shape));
            return quadric(*std::get_if<4>(&shape));
    }
}

NormalCone MeshNormals(const TriangleSampler &t) {
    const int side = t.Side();
    return {float(side < 0 ? -1 : 1) * t.Normal(), side == 0 ? -1.f : 1.f};
}
NormalCone MeshNormals(const BilinearSampler &b) {
    return b.Normals();
}

}  // namespace

bool CanEmit(const Shape &shape) {
    return !std::holds_alternative<CurveSet>(shape);
}

float Area(const Shape &shape, uint32_t primitive) {
    return Visit(
        shape, primitive, [](const auto &mesh) { return mesh.Area(); },
        [](const auto &q) { return QuadricArea(q); });
}

std::optional<ShapeSample> SampleArea(const Shape &shape, uint32_t primitive, Point2f u) {
    return Visit(
        shape, primitive, [&](const auto &mesh) { return mesh.SampleArea(u); },
        [&](const auto &q) { return std::optional<ShapeSample>(SampleQuadric(q, u)); });
}

std::optional<ShapeSample> SampleFrom(const Shape &shape, uint32_t primitive, Point3f ref,
                                      Point2f u) {
    return Visit(
        shape, primitive, [&](const auto &mesh) { return mesh.SampleFrom(ref, u); },
        [&](const auto &q) { return SampleQuadricFrom(q, ref, u); });
}

float PDFFrom(const Shape &shape, uint32_t primitive, Point3f ref, Vector3f, Point3f p,
              Normal3f n) {
    return Visit(
        shape, primitive, [&](const auto &mesh) { return mesh.PDFFrom(ref, p, n); },
        [&](const auto &q) { return QuadricPDFFrom(q, ref, p, n); });
}

NormalCone NormalBounds(const Shape &shape, uint32_t primitive) {
    return Visit(
        shape, primitive, [](const auto &mesh) { return MeshNormals(mesh); },
        [](const auto &q) { return QuadricNormals(q); });
}

}  // namespace pbrt
