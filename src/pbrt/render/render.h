#pragma once

#include <functional>
#include <optional>

#include "pbrt/build/render_scene.h"
#include "pbrt/integrators/path/path_state.h"

namespace pbrt {

struct RenderStats {
    double seconds = 0;
    int64_t cameraSamples = 0;
    RayCounts rays;
};

/// Renders the scene's film with `nThreads` threads (0: all cores). The picture does not depend on
/// their number. `progress(done, total)`, in samples, is called from any thread, often, and may
/// return false to stop early; then nullopt is returned.
///
/// `afterWave`, if given: all pixels get their first sample, then as many as they have again and
/// again, and afterWave(samples per pixel) is called each time, when the film holds the picture of
/// these: at 1, 2, 4, ... and at the last. RenderScene::targetError is ignored. Takes
/// sizeof(Film::Pixel) bytes a pixel more, and the picture's roundings are others.
std::optional<RenderStats> Render(RenderScene &scene, int nThreads,
                                  const std::function<bool(int64_t, int64_t)> &progress,
                                  const std::function<void(int)> &afterWave = {});

}  // namespace pbrt
