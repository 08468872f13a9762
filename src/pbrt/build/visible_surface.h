#pragma once

#include <optional>

#include "pbrt/build/render_scene.h"

namespace pbrt {

/// First surface that scatters along a camera ray, as a path finds it; for films that keep it.
/// Apart from the path, so that paths that nobody looks at cost nothing.
std::optional<VisibleSurface> FindVisibleSurface(const RenderScene &scene, const Ray &ray,
                                                 SampledWavelengths lambda);

}  // namespace pbrt
