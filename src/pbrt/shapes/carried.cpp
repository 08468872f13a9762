#include "pbrt/shapes/carried.h"

#include <cmath>

namespace pbrt {
namespace {

/// Upper left part of the matrix, in double: tiny and huge shapes have determinants beyond floats.
double Determinant(const Transform &t) {
    const Matrix4 &m = t.Matrix();
    const auto at = [&](int i, int j) { return double(m[i % 3][j % 3]); };
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += at(0, i) * (at(1, i + 1) * at(2, i + 2) - at(1, i + 2) * at(2, i + 1));
    return sum;
}

/// A density per solid angle about a point, in rendering space instead of object space: along the
/// direction w a linear map M turns solid angles by |det M| |w|^3 / |M w|^3.
float PerRenderingAngle(float pdf, const Transform &t, Vector3f inObject, Vector3f inRendering) {
    const double stretch = double(Length(inRendering)) / double(Length(inObject));
    return float(double(pdf) * stretch * stretch * stretch / std::abs(Determinant(t)));
}

bool HasOneLinearPart(const Instance &motion) {
    for (size_t key = 1; key < motion.NKeys(); ++key)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (motion.Key(key).Matrix()[i][j] != motion.Key(0).Matrix()[i][j]) return false;
    return true;
}

}  // namespace

std::optional<ShapeSample> SampleFromCarried(const Shape &shape, uint32_t primitive,
                                             const Transform &renderFromObject, Point3f ref,
                                             Point2f u) {
    const Point3f from = renderFromObject.Inverse().Point(ref);
    const std::optional<ShapeSample> own = SampleFrom(shape, primitive, from, u);
    if (!own) return {};
    SurfaceInteraction s{};
    s.p = own->p;
    s.pError = own->pError;
    s.n = s.ns = own->n;
    const SurfaceInteraction placed = FromInstance(renderFromObject, s);
    return ShapeSample{
        placed.p, placed.pError, placed.n, own->uv,
        PerRenderingAngle(own->pdf, renderFromObject, own->p - from, placed.p - ref)};
}

float PDFFromCarried(const Shape &shape, uint32_t primitive, const Transform &renderFromObject,
                     Point3f ref, Point3f p, Normal3f n) {
    const Transform inverse = renderFromObject.Inverse();
    const Point3f from = inverse.Point(ref), at = inverse.Point(p);
    const float own = PDFFrom(shape, primitive, from, at, Normalize(inverse.Normal(n)));
    return own > 0 ? PerRenderingAngle(own, renderFromObject, at - from, p - ref) : 0;
}

float AreaCarried(const Shape &shape, uint32_t primitive, const Transform &renderFromObject) {
    // A piece of area with the normal n grows by |det M| |M^-T n|; the mean over a grid of points.
    constexpr int kGrid = 16;
    double sum = 0;
    for (int i = 0; i < kGrid; ++i)
        for (int j = 0; j < kGrid; ++j) {
            const Point2f u{(float(i) + 0.5f) / kGrid, (float(j) + 0.5f) / kGrid};
            const std::optional<ShapeSample> s = SampleArea(shape, primitive, u);
            if (s && s->pdf > 0) sum += Length(renderFromObject.Normal(s->n)) / s->pdf;
        }
    return float(sum / (kGrid * kGrid) * std::abs(Determinant(renderFromObject)));
}

/// Between keys each point goes straight on.
Bounds3f BoundsCarried(const Shape &shape, uint32_t primitive, const Instance &motion) {
    Bounds3f bounds;
    for (size_t key = 0; key < motion.NKeys(); ++key)
        bounds.Grow(motion.Key(key).Bounds(PrimitiveBounds(shape, primitive)));
    return bounds;
}

/// All directions, but for flat primitives that do not turn.
NormalCone NormalBoundsCarried(const Shape &shape, uint32_t primitive, const Instance &motion) {
    const NormalCone own = NormalBounds(shape, primitive);
    if (own.cosTheta < 1 || !HasOneLinearPart(motion)) return {{0, 0, 1}, -1};
    return {Normalize(motion.Key(0).Normal(own.axis)), 1};
}

}  // namespace pbrt
