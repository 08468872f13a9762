#pragma once

#include <functional>
#include <optional>

#include "pbrt/cpu/path_state.h"
#include "pbrt/cpu/world.h"

namespace pbrt {

struct RenderStats {
    double seconds = 0;
    int64_t cameraSamples = 0;
    RayCounts rays;
};

/// Renders the world's film with `nThreads` threads (0: all cores). The picture does not depend on
/// their number. `progress(done, total)`, in pixels, is called from any thread, often, and may
/// return false to stop early; then nullopt is returned.
std::optional<RenderStats> Render(World &world, int nThreads,
                                  const std::function<bool(int64_t, int64_t)> &progress);

}  // namespace pbrt
