#pragma once

#include <span>

#include "pbrt/build/render_scene.h"
#include "pbrt/integrators/path/path_batch.h"
#include "pbrt/integrators/path/path_state.h"
#include "pbrt/integrators/path/settings.h"

namespace pbrt {

/// Materials whose vertices are worked out by the same code: those of one type that are uniform, or
/// those that are not.
struct ShadeGroup {
    /// Place in the list of groups, of which there are two for each type of material.
    static size_t IndexOf(const MaterialFacts &facts) { return 2 * facts.type + facts.isUniform; }

    /// SurfaceVertices::Shade for up to sixteen paths that meet materials of the group.
    void (*shade)(const RenderScene &scene, const PathSettings &settings, PathBatch &batch,
                  const VertexNumbers &numbers, const UintX16 &places, int count) = nullptr;
    bool oneLobe = false;  ///< reads no VertexNumbers::lobe; see MaterialTraits::oneLobe
};

/// Groups of all materials, made in shade_groups.cpp: the one file a new material compiles anew.
std::span<const ShadeGroup> ShadeGroups();

}  // namespace pbrt
