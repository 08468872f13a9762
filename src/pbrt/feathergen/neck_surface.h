#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/feathergen/bent_axis.h"
#include "pbrt/feathergen/mesh.h"

namespace pbrt::feathergen {

/// A place on a surface, millimetres.
struct SurfaceSample {
    Vec3d p, n;    ///< n: unit, outwards
    double along;  ///< 0 where the flow begins, 1 where it ends
};

/// A neck of 68 mm, 12 mm wide at the head (+z) and 27 mm at the breast, which bulges to -y.
Mesh BuiltInNeck();

/// Triangles and quads (split) of a PLY file; normals, where it has none, are means of the faces'.
std::optional<Mesh> ReadSurface(const std::string &fileName, std::string *problem);

/// `count` places spread evenly at random over the surface; `flow` is the direction (not zero) in
/// which feathers lie. None where the surface has no area.
std::vector<SurfaceSample> SampleSurface(const Mesh &mesh, Vec3d flow, size_t count, uint64_t seed);

}  // namespace pbrt::feathergen
