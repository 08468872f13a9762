#include "pbrt/util/upstream.h"

#include <array>

namespace pbrt {
namespace {

// One row a line: scripts/compatibility.sh reads them, too.
constexpr std::array kNames{
    UpstreamName{"camera", "realistic", "perspective"},
    UpstreamName{"camera", "spherical", ""},
    UpstreamName{"sampler", "halton", "zsobol"},
    UpstreamName{"sampler", "paddedsobol", "zsobol"},
    UpstreamName{"sampler", "pmj02bn", "zsobol"},
    UpstreamName{"sampler", "sobol", "zsobol"},
    UpstreamName{"integrator", "bdpt", "path"},
    UpstreamName{"integrator", "function", ""},
    UpstreamName{"integrator", "lightpath", "path"},
    UpstreamName{"integrator", "mlt", "path"},
    UpstreamName{"integrator", "simplevolpath", ""},
    UpstreamName{"integrator", "sppm", "path"},
    UpstreamName{"accelerator", "kdtree", "bvh"},
    UpstreamName{"material", "measured", ""},
    UpstreamName{"material", "subsurface", ""},
    UpstreamName{"texture class", "bilerp", ""},
    UpstreamName{"texture class", "marble", ""},
    UpstreamName{"texture class", "windy", ""},
    UpstreamName{"option of pbrt", "debugstart", ""},
    UpstreamName{"option of pbrt", "disableimagetextures", ""},
    UpstreamName{"option of pbrt", "displacementedgescale", ""},
    UpstreamName{"option of pbrt", "displayserver", ""},
    UpstreamName{"option of pbrt", "format", ""},
    UpstreamName{"option of pbrt", "fullscreen", ""},
    UpstreamName{"option of pbrt", "gpu", ""},
    UpstreamName{"option of pbrt", "gpudevice", ""},
    UpstreamName{"option of pbrt", "interactive", ""},
    UpstreamName{"option of pbrt", "logfile", ""},
    UpstreamName{"option of pbrt", "loglevel", ""},
    UpstreamName{"option of pbrt", "logutilization", ""},
    UpstreamName{"option of pbrt", "pixelmaterial", ""},
    UpstreamName{"option of pbrt", "pixelstats", ""},
    UpstreamName{"option of pbrt", "toply", ""},
    UpstreamName{"option of pbrt", "upgrade", ""},
    UpstreamName{"option of pbrt", "wavefront", ""},
    UpstreamName{"option of pbrt", "writepartialimages", ""},
    UpstreamName{"command of imgtool", "assemble", ""},
    UpstreamName{"command of imgtool", "bloom", ""},
    UpstreamName{"command of imgtool", "cat", "info"},
    UpstreamName{"command of imgtool", "falsecolor", ""},
    UpstreamName{"command of imgtool", "makeemitters", ""},
    UpstreamName{"command of imgtool", "makesky", ""},
    UpstreamName{"command of imgtool", "scalenormalmap", ""},
    UpstreamName{"command of imgtool", "splitn", ""},
    UpstreamName{"command of imgtool", "whitebalance", ""},
};

}  // namespace

std::span<const UpstreamName> NotBuiltHere() {
    return kNames;
}

std::string PbrtHasIt(std::string_view kind, std::string_view name) {
    for (const UpstreamName &row : kNames) {
        if (row.kind != kind || row.name != name) continue;
        std::string text = "; pbrt-v4 has it, not built here";
        if (!row.instead.empty()) text += "; use \"" + std::string(row.instead) + '"';
        return text;
    }
    return {};
}

}  // namespace pbrt
