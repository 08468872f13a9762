#include "pbrt/util/upstream.h"

#include <array>

namespace pbrt {
namespace {

// scripts/compatibility.sh reads them, too.
constexpr std::array kNames{
    UpstreamName{"camera", "realistic", "Use \"perspective\" with \"fov\" and \"lensradius\""},
    UpstreamName{"integrator", "function", "It tests samplers and shows no scene; use \"path\""},
    UpstreamName{"medium", "cloud",
                 "Only surfaces are rendered: take out medium and MediumInterface"},
    UpstreamName{"medium", "homogeneous",
                 "Only surfaces are rendered: take out medium and MediumInterface"},
    UpstreamName{"medium", "nanovdb",
                 "Only surfaces are rendered: take out medium and MediumInterface"},
    UpstreamName{"medium", "rgbgrid",
                 "Only surfaces are rendered: take out medium and MediumInterface"},
    UpstreamName{"medium", "uniformgrid",
                 "Only surfaces are rendered: take out medium and MediumInterface"},
    UpstreamName{"material", "measured",
                 "Use \"conductor\" or \"coateddiffuse\" with a color like it"},
    UpstreamName{"material", "subsurface", "Use \"coateddiffuse\" with the color that it shows"},
    UpstreamName{
        "material \"coatedconductor\"", "albedo",
        "A coat that scatters is refused: \"mix\" it with \"diffuse\" of the coat's color"},
    UpstreamName{"material \"coateddiffuse\"", "albedo",
                 "A coat that scatters is refused: give the base the color that both show"},
    UpstreamName{"texture class", "bilerp", "Use \"imagemap\" with a picture of 2 x 2 pixels"},
    UpstreamName{"texture class", "marble", "Use \"imagemap\" with a picture of it"},
    UpstreamName{"texture class", "windy", "Use \"fbm\" or \"imagemap\""},
    UpstreamName{"option of pbrt", "debugstart", "Use --pixel x,y"},
    UpstreamName{"option of pbrt", "disableimagetextures",
                 "Use textures of the class \"constant\""},
    UpstreamName{"option of pbrt", "displacementedgescale", "Use \"edgelength\" of the shape"},
    UpstreamName{"option of pbrt", "fullscreen", "Use --display-server with a viewer such as tev"},
    UpstreamName{"option of pbrt", "gpu",
                 "The processor renders, sixteen paths at a time: leave it out"},
    UpstreamName{"option of pbrt", "gpudevice", "The processor renders: leave it out"},
    UpstreamName{"option of pbrt", "interactive", "Use --display-server with a viewer such as tev"},
    UpstreamName{"option of pbrt", "logfile", "Messages go to standard error: use 2> file"},
    UpstreamName{"option of pbrt", "loglevel", "Use --quiet, or nothing"},
    UpstreamName{"option of pbrt", "logutilization", "Use --stats"},
    UpstreamName{"option of pbrt", "pixelmaterial", "Use --pixel x,y with the film \"gbuffer\""},
    UpstreamName{"option of pbrt", "wavefront",
                 "Paths are traced in batches as it is: leave it out"},
    UpstreamName{"command of imgtool", "makeemitters", ""},
    UpstreamName{"command of imgtool", "makesky", ""},
};

constexpr std::array kOldNames{
    OldName{"film", "image", "rgb"},
    OldName{"camera", "environment", "spherical"},
    OldName{"sampler", "02sequence", "paddedsobol"},
    OldName{"sampler", "lowdiscrepancy", "paddedsobol"},
    OldName{"sampler", "maxmindist", "pmj02bn"},
    OldName{"sampler", "random", "independent"},
    OldName{"area light", "area", "diffuse"},
    OldName{"integrator", "directlighting", "path"},
    OldName{"integrator", "whitted", "path"},
    OldName{"material", "disney", "diffuse"},
    OldName{"material", "fourier", "measured"},
    OldName{"material", "glass", "dielectric"},
    OldName{"material", "kdsubsurface", "subsurface"},
    OldName{"material", "matte", "diffuse"},
    OldName{"material", "metal", "conductor"},
    OldName{"material", "mirror", "conductor"},
    OldName{"material", "plastic", "coateddiffuse"},
    OldName{"material", "substrate", "coateddiffuse"},
    OldName{"material", "translucent", "diffusetransmission"},
    OldName{"material", "uber", "coateddiffuse"},
    OldName{"texture type", "color", "spectrum"},
    OldName{"directive", "SurfaceIntegrator", "Integrator"},
    OldName{"directive", "WorldEnd", ""},
    OldName{"parameter type", "color", "rgb"},
    OldName{"parameter type", "point", "point3"},
    OldName{"parameter type", "vector", "vector3"},
    OldName{"parameter type", "xyz", "rgb"},
    OldName{"parameter", "bumpmap", "displacement"},
    OldName{"parameter", "Kd", "reflectance"},
    OldName{"parameter", "mapname", "filename"},
    OldName{"parameter", "maxsampleluminance", "maxcomponentvalue"},
    OldName{"parameter", "xwidth", "xradius"},
    OldName{"parameter", "ywidth", "yradius"},
};

}  // namespace

std::span<const UpstreamName> NotBuiltHere() {
    return kNames;
}

std::string PbrtHasIt(std::string_view kind, std::string_view name) {
    for (const UpstreamName &row : kNames) {
        if (row.kind != kind || row.name != name) continue;
        std::string text = "pbrt-v4 has it; not built here";
        if (!row.advice.empty()) text.append(". ").append(row.advice);
        return text;
    }
    return {};
}

std::string CalledNow(const OldName &old) {
    std::string text = "pbrt-v4 calls it \"" + std::string(old.is) + '"';
    if (!PbrtHasIt(old.kind, old.is).empty()) text += ", which is not built here";
    return text;
}

const OldName *FindOldName(std::string_view kind, std::string_view name) {
    for (const OldName &row : kOldNames)
        if (row.kind == kind && row.was == name) return &row;
    return nullptr;
}

}  // namespace pbrt
