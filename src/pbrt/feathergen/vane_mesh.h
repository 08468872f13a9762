#pragma once

#include "pbrt/feathergen/feather.h"
#include "pbrt/feathergen/mesh.h"

namespace pbrt::feathergen {

/// Atlas: uv of one image for the whole feather, vertices shared. Faces: (0,0) to (1,1) in every
/// quad, which has its own four vertices and its number in Mesh::faces.
enum class VaneUV { Atlas, Faces };

/// All left or all right banks. Quads are not flat, so each is two triangles: these are traced
/// natively, which bent patches are not, and their dp/du and dp/dv still are the quad's edges.
Mesh VaneMesh(const Feather &feather, Bank bank, VaneUV uv);

/// The rami of all barbs as tubes.
Mesh RamusMesh(const Feather &feather);
Mesh RachisMesh(const Feather &feather);

}  // namespace pbrt::feathergen
