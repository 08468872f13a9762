#pragma once

#include "pbrt/shapes/shapes.h"

namespace pbrt {

// Shapes that Embree traces by itself. A new one has its line here and its NewNative in native.cpp;
// all others intersect themselves, and need neither.

template <typename S>
inline constexpr bool kMayBeNative = false;
template <>
inline constexpr bool kMayBeNative<TriangleMesh> = true;
template <>
inline constexpr bool kMayBeNative<BilinearMesh> = true;
template <>
inline constexpr bool kMayBeNative<CurveSet> = true;

template <ShapeType S>
bool IsNative(const S &) {
    static_assert(kMayBeNative<S> || S::kTraits.intersectsItself,
                  "a shape that does not intersect itself needs a NewNative here");
    return kMayBeNative<S>;
}
/// Planar meshes are taken as quads; bent patches intersect themselves.
inline bool IsNative(const BilinearMesh &mesh) {
    return mesh.planar;
}
bool IsNative(const Shape &shape);

}  // namespace pbrt
