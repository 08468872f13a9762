#include <fmt/format.h>

#include "pbrt/bsdftool/command_line.h"
#include "pbrt/bsdftool/scatterogram.h"

namespace pbrt::bsdftool {
namespace {

struct Options {
    CommonOptions common;
    std::vector<std::string> lights;
    std::string value = "fcos", exr, png;
    float exposure = 0;  ///< 0: automatic
    ScatterogramOptions picture;
};

std::optional<Outcome> ParseOptions(Args args, Options *o) {
    CLI::App app(
        "Pictures of the light that a material scatters, for each light one disc of its own side "
        "and one of the other, seen from above: the point (x, y) of a disc is the direction with "
        "these components. What passes straight through gaps, or is mirrored exactly, is not seen.",
        "bsdftool plot");
    AddMaterial(&app, &o->common);
    app.add_option("--light", o->lights,
                   "theta,phi of the light, degrees; may be repeated (default: 30,0)")
        ->allow_extra_args(false);
    app.add_option("--value", o->value,
                   "fcos (default): f times the cosine of the scattered direction; f: f itself")
        ->check(CLI::IsMember({"fcos", "f"}));
    app.add_option("--exposure", o->exposure,
                   "factor of the PNG's values (default: such that one in a hundred is too bright)")
        ->check(CLI::PositiveNumber);
    app.add_option("--resolution", o->picture.resolution, "pixels across a disc (default: 256)")
        ->check(CLI::Range(8, 4096));
    app.add_option("--subpixels", o->picture.subpixels,
                   "directions per pixel, each way (default: 2)")
        ->check(CLI::Range(1, 64));
    app.add_option("--wavelengths", o->picture.wavelengths,
                   "how many make up a color (default: 40; films of many micrometres need more)")
        ->check(CLI::Range(4, 4096));
    AddIlluminant(&app, &o->common);
    app.add_option("--exr", o->exr, "file for the values: linear sRGB without exposure");
    app.add_option("--png", o->png, "file for a sheet with axes");
    return cli::Parse(&app, args);
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

}  // namespace

Outcome RunPlot(Args args) {
    Options o;
    if (auto end = ParseOptions(args, &o)) return *end;
    Diagnostics log;
    const auto source = ReadMaterial(o.common, log);
    const Spectrum illuminant = ReadIlluminant(o.common, log);
    const std::vector<LightAngles> lights = ReadLights(o.lights, log);
    CheckOutputs(o, log);
    if (log.HasErrors()) return Finish(log);

    o.picture.timesCosine = o.value == "fcos";
    std::vector<Scatterogram> views;
    for (const LightAngles &light : lights)
        views.push_back(ScatterLight(source->material, light, o.picture, illuminant));
    const float exposure = o.exposure > 0 ? o.exposure : AutomaticExposure(views);
    if (!o.exr.empty())
        if (const auto why = WriteImage(SideBySide(views), o.exr, ExrPixels::Float))
            log.Error({}, *why);
    WriteText(o.png,
              o.png.empty()
                  ? std::string()
                  : ScatterogramSheet(views, exposure, o.common.material,
                                      o.picture.timesCosine ? "f cos(theta) [1/sr]" : "f [1/sr]"),
              log);
    return Finish(log, fmt::format("exposure {:.6g}\n", exposure));
}

}  // namespace pbrt::bsdftool
