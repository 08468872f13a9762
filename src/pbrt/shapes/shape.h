#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pbrt/scene/description.h"
#include "pbrt/shapes/surface.h"
#include "pbrt/shapes/surface_interaction.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

// SurfaceAt and SurfaceAtWithoutError, called once per ray, are inline: interact.h.

/// Makes the shapes one directive describes: usually one; a PLY file with triangles and quads makes
/// two. Empty after an error (which is in the log). Parameters that no one read are errors, but
/// those of an unknown shape.
std::vector<Shape> CreateShapes(const ShapeEntity &entity, ParamDict &params,
                                const Transform &renderFromObject);
std::span<const std::string_view> ShapeNames();

/// The one patch that a mesh of two triangles covers, with the same normal, if it is a
/// parallelogram without vertex normals (to 1e-5 of its sides) whose triangles are (a b c) and (a c
/// d).
std::optional<Shape> AsParallelogram(const TriangleMesh &mesh);

/// Adds the curves of `more` to `into`; false, and nothing done, where their kinds differ or the
/// points would outgrow their 32-bit numbers.
bool Append(const CurveSet &more, CurveSet *into);

size_t NPrimitives(const Shape &shape);
Bounds3f Bounds(const Shape &shape);

/// Curves cannot: the functions below are for the others.
bool CanEmit(const Shape &shape);
float Area(const Shape &shape, uint32_t primitive);
/// Uniform by area, but for bent bilinear patches, quadrics stretched unevenly: near that, with the
/// density there. pdf per unit area.
std::optional<ShapeSample> SampleArea(const Shape &shape, uint32_t primitive, Point2f u);
/// As seen from `ref`: pdf per unit solid angle. Spheres by their cone, triangles by their
/// spherical triangle where it is neither tiny nor huge, rectangles likewise, else by area.
std::optional<ShapeSample> SampleFrom(const Shape &shape, uint32_t primitive, Point3f ref,
                                      Point2f u);
/// Density of SampleFrom for the direction wi from ref, which is known to meet the primitive at
/// `p` with normal n.
float PDFFrom(const Shape &shape, uint32_t primitive, Point3f ref, Vector3f wi, Point3f p,
              Normal3f n);
NormalCone NormalBounds(const Shape &shape, uint32_t primitive);

}  // namespace pbrt
