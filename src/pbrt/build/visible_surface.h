#pragma once

#include <optional>

#include "pbrt/build/render_scene.h"

namespace pbrt {

/// What scatters first along a camera ray, as a path along it finds it; for films that keep it.
/// Apart from the path, so that paths that nobody looks at cost nothing.
std::optional<VisibleSurface> FindVisibleSurface(const RenderScene &scene, const Ray &ray,
                                                 SampledWavelengths lambda);

}  // namespace pbrt
