#pragma once

#include <optional>
#include <string>

#include "pbrt/render/render.h"

namespace pbrt {

/// Time and memory used by one run of `pbrt`.
struct Statistics {
    double parseSeconds = 0, buildSeconds = 0;
    RenderStats render;
    int64_t peakBytes = 0;           ///< largest resident set of the process so far; 0: unknown
    int64_t traversalBytes = 0;      ///< held for traversal, mostly by the ray tracer
    int64_t traversalPeakBytes = 0;  ///< the most it was, while it was built
};

/// Statistics of this process now, for a scene that has been rendered.
Statistics CollectStatistics(const RenderScene &scene, const RenderStats &render,
                             double parseSeconds, double buildSeconds);

/// Lines for people.
std::string StatisticsText(const Statistics &s);

/// One JSON object for programs: parseSeconds, buildSeconds, renderSeconds, cameraSamples,
/// closestHitRays, shadowRays, peakBytes, traversalBytes, traversalPeakBytes.
std::string StatisticsJson(const Statistics &s);

}  // namespace pbrt
