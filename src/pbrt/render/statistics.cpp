#include "pbrt/render/statistics.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace pbrt {
namespace {

/// 0 where the system does not tell. From /proc, for getrusage counts what the process that started
/// this one held, too (Linux keeps the larger of the two over exec).
int64_t PeakBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (int64_t kiB = 0; word == "VmHWM:" && status >> kiB) return kiB * 1024;
    return 0;
}

}  // namespace

Statistics CollectStatistics(const RenderScene &scene, const RenderStats &render,
                             double parseSeconds, double buildSeconds) {
    Statistics s;
    s.parseSeconds = parseSeconds;
    s.buildSeconds = buildSeconds;
    s.render = render;
    s.peakBytes = PeakBytes();
    s.traversalBytes = int64_t(scene.accel->MemoryBytes());
    s.traversalPeakBytes = int64_t(scene.accel->PeakMemoryBytes());
    return s;
}

std::string StatisticsText(const Statistics &s) {
    const double seconds = s.render.seconds;
    const double closest = s.render.rays.closest * 1e-6, shadow = s.render.rays.shadow * 1e-6;
    const double samples = s.render.cameraSamples * 1e-6, rays = closest + shadow;
    return fmt::format(
        "Parse          {:10.3f} s\nBuild          {:10.3f} s\nRender         {:10.3f} s\n"
        "Camera samples {:10.3f} M   {:8.3f} M/s\n"
        "Rays           {:10.3f} M   {:8.3f} M/s (closest hit {:.3f} M, shadow {:.3f} M)\n"
        "Memory         {:10.1f} MiB peak; traversal {:.1f} MiB, {:.1f} MiB while built\n",
        s.parseSeconds, s.buildSeconds, seconds, samples, samples / seconds, rays, rays / seconds,
        closest, shadow, s.peakBytes / 1048576.0, s.traversalBytes / 1048576.0,
        s.traversalPeakBytes / 1048576.0);
}

std::string StatisticsJson(const Statistics &s) {
    const nlohmann::ordered_json json = {{"parseSeconds", s.parseSeconds},
                                         {"buildSeconds", s.buildSeconds},
                                         {"renderSeconds", s.render.seconds},
                                         {"cameraSamples", s.render.cameraSamples},
                                         {"closestHitRays", s.render.rays.closest},
                                         {"shadowRays", s.render.rays.shadow},
                                         {"peakBytes", s.peakBytes},
                                         {"traversalBytes", s.traversalBytes},
                                         {"traversalPeakBytes", s.traversalPeakBytes}};
    return json.dump(2) + "\n";
}

}  // namespace pbrt
