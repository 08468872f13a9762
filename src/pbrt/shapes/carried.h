#pragma once

#include <optional>

#include "pbrt/shapes/instanced.h"
#include "pbrt/shapes/shapes.h"

namespace pbrt {

// Emitters in motion: shapes in their own space that an instance carries about rendering space. The
// members of EmittingShape (base/shape.h), at one of its transforms or over its whole motion.

/// As SampleFrom; `ref` and the sample are in rendering space.
std::optional<ShapeSample> SampleFromCarried(const Shape &shape, uint32_t primitive,
                                             const Transform &renderFromObject, Point3f ref,
                                             Point2f u);
/// As PDFFrom; all places are in rendering space.
float PDFFromCarried(const Shape &shape, uint32_t primitive, const Transform &renderFromObject,
                     Point3f ref, Point3f p, Normal3f n);
/// To 1 % where the transform stretches a bent shape unevenly, else as Area.
float AreaCarried(const Shape &shape, uint32_t primitive, const Transform &renderFromObject);
/// Hold the primitive and its normals at all times.
Bounds3f BoundsCarried(const Shape &shape, uint32_t primitive, const Instance &motion);
NormalCone NormalBoundsCarried(const Shape &shape, uint32_t primitive, const Instance &motion);

}  // namespace pbrt
