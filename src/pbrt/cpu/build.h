#pragma once

#include <memory>

#include "pbrt/cpu/world.h"

namespace pbrt {

/// What the command line overrides of a scene.
struct Overrides {
    FilmOverrides film;
    std::optional<int> spp;
    int nThreads = 0;  ///< for building the acceleration structure; 0: all cores
};

/// Makes everything the description names. Mistakes go to the log; where there are any, nullptr is
/// returned (after as many as possible have been found).
std::unique_ptr<World> BuildWorld(const Description &scene, const Overrides &overrides,
                                  Diagnostics &log);

}  // namespace pbrt
