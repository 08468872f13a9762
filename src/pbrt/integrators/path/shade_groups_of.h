#pragma once

#include <array>

#include "pbrt/integrators/path/shade_groups.h"
#include "pbrt/integrators/path/surface_vertices.h"
#include "pbrt/materials/materials.h"

namespace pbrt {

template <typename M, bool kUniform, typename Scattering>
void ShadeVertices(const RenderScene &scene, const PathSettings &settings, PathBatch &batch,
                   const VertexNumbers &numbers, const UintX16 &places, int count) {
    SurfaceVertices<M, kUniform, Scattering>(scene, settings, batch, numbers).Shade(places, count);
}

/// The groups of all materials, with BSDFs as `Scattering` makes them; see ShadeGroup::IndexOf.
template <typename Scattering>
constexpr auto ShadeGroupsOf() {
    std::array<ShadeGroup, 2 * MaterialTypes::kNames.size()> groups{};
    size_t next = 0;
    MaterialTypes::ForEach([&]<typename M>() {
        constexpr bool kOneLobe = M::kTraits.oneLobe;
        groups[next++] = {ShadeVertices<M, false, Scattering>, kOneLobe};
        // Types of which none is ever uniform leave a gap.
        if constexpr (M::kTraits.canBeUniform)
            groups[next] = {ShadeVertices<M, true, Scattering>, kOneLobe};
        ++next;
    });
    return groups;
}

}  // namespace pbrt
