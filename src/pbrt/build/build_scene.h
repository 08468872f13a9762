#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "pbrt/build/render_scene.h"

namespace pbrt {

/// Scene settings that the command line overrides.
struct SceneOverrides {
    FilmOverrides film;
    std::optional<int> spp;
    int nThreads = 0;  ///< for building the acceleration structure; 0: all cores
};

/// Embree chooses for itself: pbrt's hints are checked and have no effect.
void ReadAccelerator(std::string_view type, ParamDict &params);
std::span<const std::string_view> AcceleratorNames();

/// Makes everything the description names. Mistakes go to the log; where there are any, nullptr is
/// returned (after as many as possible have been found). The description is used up: shapes and
/// unnamed materials are let go as they are built.
std::unique_ptr<RenderScene> BuildScene(SceneDescription &&description,
                                        const SceneOverrides &overrides, Diagnostics &log);

}  // namespace pbrt
