#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pbrt/base/shape.h"
#include "pbrt/shapes/bilinear_mesh.h"
#include "pbrt/shapes/curve.h"
#include "pbrt/shapes/cylinder.h"
#include "pbrt/shapes/disk.h"
#include "pbrt/shapes/loop_subdiv.h"
#include "pbrt/shapes/ply_mesh.h"
#include "pbrt/shapes/sphere.h"
#include "pbrt/shapes/triangle_mesh.h"
#include "pbrt/textures/texture.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of shapes; base/shape.h is their contract, docs/EXTENDING.md the way to a new one.
using ShapeTypes = TypeList<TriangleMesh, BilinearMesh, Sphere, Disk, Cylinder, CurveSet>;
using Shape = ShapeTypes::Variant;

static_assert(ShapeTypes::All([]<typename S>() { return ShapeContract<S>::value; }));

/// Types that a `Shape` directive may name: the shapes, and what becomes shapes.
using ShapeDirectives = ShapeTypes::Append<LoopSubdivision, PlyFile>;

/// Makes the shapes one directive describes: usually one; a PLY file with triangles and quads makes
/// two. Empty after an error (which is in the log). Parameters that no one read are errors, but
/// those of an unknown shape.
std::vector<Shape> CreateShapes(const ShapeEntity &entity, ParamDict &params,
                                const Transform &renderFromObject,
                                const NamedTextures &textures = {});

// The members of base/shape.h, of whichever type it is.

template <bool kWithError>
inline SurfaceInteraction SurfaceAtWith(const Shape &shape, const Hit &hit, const Ray &ray) {
    return Dispatch(shape,
                    [&](const auto &s) { return s.template SurfaceAt<kWithError>(hit, ray); });
}
/// Everything about a hit that shading needs. `hit.t` along `ray`; for instances the ray and the
/// result are in the instance's object space.
inline SurfaceInteraction SurfaceAt(const Shape &shape, const Hit &hit, const Ray &ray) {
    return SurfaceAtWith<true>(shape, hit, ray);
}
/// SurfaceAt without pError: for alpha tests and null transmission, where no ray starts.
inline SurfaceInteraction SurfaceAtWithoutError(const Shape &shape, const Hit &hit,
                                                const Ray &ray) {
    return SurfaceAtWith<false>(shape, hit, ray);
}

size_t NPrimitives(const Shape &shape);
Bounds3f Bounds(const Shape &shape);
Bounds3f PrimitiveBounds(const Shape &shape, uint32_t primitive);

/// The functions below are for shapes that can.
bool CanEmit(const Shape &shape);
float Area(const Shape &shape, uint32_t primitive);
std::optional<ShapeSample> SampleArea(const Shape &shape, uint32_t primitive, Point2f u);
std::optional<ShapeSample> SampleFrom(const Shape &shape, uint32_t primitive, Point3f ref,
                                      Point2f u);
/// Density of SampleFrom for the direction from ref to the primitive's point p with normal n.
float PDFFrom(const Shape &shape, uint32_t primitive, Point3f ref, Point3f p, Normal3f n);
NormalCone NormalBounds(const Shape &shape, uint32_t primitive);

}  // namespace pbrt
