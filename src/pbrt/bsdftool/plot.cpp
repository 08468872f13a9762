#include <fmt/format.h>

#include "pbrt/bsdftool/command_line.h"
#include "pbrt/bsdftool/lobe_plot.h"
#include "pbrt/cli/options.h"

namespace pbrt::bsdftool {
namespace {

struct Options {
    CommonOptions common;
    std::vector<std::string> lights;
    std::string value = "fcos", exr, png;
    float exposure = 0;  ///< 0: automatic
    ScatterogramOptions picture;
};

constexpr char kDescription[] =
    "Pictures of the light that a material scatters, for each light one disc of its own side "
    "and one of the other, seen from above: the point (x, y) of a disc is the direction with "
    "these components. What passes straight through gaps, or is mirrored exactly, is not seen.";

void DefineOptions(CLI::App *app, Options *o) {
    AddMaterial(app, &o->common);
    cli::AddRepeated(app, "--light", &o->lights,
                     "where the light is, degrees; may be repeated (default: 30,0)", "theta,phi");
    cli::AddChoice(app, "--value", &o->value, {"fcos", "f"},
                   "fcos (default): f times the cosine of the scattered direction; f: f itself");
    cli::AddNumber(
        app, "--exposure", &o->exposure, cli::kAboveZero,
        "factor of the PNG's values (default: such that one in a hundred is too bright)");
    cli::AddNumber(app, "--resolution", &o->picture.resolution, {.lo = 8, .hi = 4096},
                   "pixels across a disc (default: 256)");
    cli::AddNumber(app, "--subpixels", &o->picture.subpixels, {.lo = 1, .hi = 64},
                   "directions per pixel, each way (default: 2)");
    cli::AddNumber(app, "--wavelengths", &o->picture.wavelengths, {.lo = 4, .hi = 4096},
                   "how many make up a color (default: 40; films of many micrometres need more)");
    AddIlluminant(app, &o->common);
    cli::AddText(app, "--exr", &o->exr, "file for the values: linear sRGB without exposure");
    cli::AddText(app, "--png", &o->png, "file for a sheet with axes");
}

std::vector<LightAngles> ReadLights(const std::vector<std::string> &texts, Diagnostics &log) {
    if (texts.empty()) return {{30, 0}};
    std::vector<LightAngles> lights;
    for (const std::string &text : texts) {
        const std::vector<float> angles = ReadNumbers(text, "--light", -360, 360, log);
        if (log.HasErrors()) continue;
        if (angles.size() != 2)
            log.Error({},
                      fmt::format("--light: expected theta,phi in degrees, found \"{}\"", text));
        else if (angles[0] < 0 || angles[0] > 180)
            log.Error({}, fmt::format("--light: theta {:g} is outside [0, 180]", angles[0]));
        else
            lights.push_back({angles[0], angles[1]});
    }
    return lights;
}

void CheckOutputs(const Options &o, Diagnostics &log) {
    if (o.exr.empty() && o.png.empty()) log.Error({}, "nothing to do: give --png, --exr or both");
    if (!o.exr.empty() && !o.exr.ends_with(".exr"))
        log.Error({}, fmt::format("--exr: the name \"{}\" does not end in .exr", o.exr));
    CheckWritable(o.exr, log);
    CheckWritable(o.png, log);
}

Outcome WithOptions(Options &o) {
    Diagnostics log;
    const auto source = ReadMaterial(o.common, log);
    const Spectrum illuminant = ReadIlluminant(o.common, log);
    const std::vector<LightAngles> lights = ReadLights(o.lights, log);
    CheckOutputs(o, log);
    if (log.HasErrors()) return Finish(log);

    o.picture.timesCosine = o.value == "fcos";
    std::vector<LobePlot> views;
    for (const LightAngles &light : lights)
        views.push_back(ScatterLight(source->material, light, o.picture, illuminant));
    const float exposure = o.exposure > 0 ? o.exposure : AutomaticExposure(views);
    if (!o.exr.empty())
        if (const auto why = WriteImage(Montage(views), o.exr, ExrPixels::Float))
            log.Error({}, *why);
    WriteText(o.png,
              o.png.empty()
                  ? std::string()
                  : ScatterogramSheet(views, exposure, o.common.material,
                                      o.picture.timesCosine ? "f cos(theta) [1/sr]" : "f [1/sr]"),
              log);
    return Finish(log, fmt::format("exposure {:.6g}\n", exposure));
}

}  // namespace

Outcome RunPlot(Args args) {
    return cli::RunWithOptions(args, "bsdftool plot", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::bsdftool
