#include "pbrt/bsdftool/command_line.h"
#include "pbrt/bsdftool/reflectance.h"
#include "pbrt/cli/options.h"

namespace pbrt::bsdftool {
namespace {

struct Options {
    CommonOptions common;
    std::string thetas = "0,5,10,15,20,25,30,35,40,45,50,55,60,65,70,75,80,85", csv, png;
    ReflectanceOptions reflectance;
};

constexpr char kDescription[] =
    "Reflectance of a material (what it scatters back to the side that the light comes from) "
    "against wavelength and angle of incidence, and the colors this makes.";

void DefineOptions(CLI::App *app, Options *o) {
    AddMaterial(app, &o->common);
    cli::AddText(app, "--thetas", &o->thetas,
                 "angles to the normal in degrees, [-90, 90] (default: 0 to 85 by 5)",
                 "theta,theta,...");
    cli::AddNumber(app, "--phi", &o->reflectance.phi, {.lo = -360, .hi = 360},
                   "azimuth from x (across barbules) towards y (along them), degrees (default: 0)");
    cli::AddNumber(app, "--step", &o->reflectance.step, {.lo = 0.1, .hi = 50},
                   "between wavelengths, nm (default: 2)");
    cli::AddNumber(app, "--samples", &o->reflectance.samples, {.lo = 16, .hi = 1 << 24},
                   "directions drawn per angle and four wavelengths (default: 2048)");
    AddIlluminant(app, &o->common);
    cli::AddText(app, "--csv", &o->csv, "file for theta,phi,lambda,reflectance and parts");
    cli::AddText(app, "--png", &o->png, "file for a plot: curves, and a strip of colors");
}

Outcome WithOptions(Options &o) {
    Diagnostics log;
    const auto source = ReadMaterial(o.common, log);
    const Spectrum illuminant = ReadIlluminant(o.common, log);
    o.reflectance.thetas = ReadNumbers(o.thetas, "--thetas", -90, 90, log);
    CheckWritable(o.csv, log);
    CheckWritable(o.png, log);
    if (log.HasErrors()) return Finish(log);
    const ReflectanceTable table = TabulateReflectance(source->material, o.reflectance, illuminant);
    WriteText(o.csv, ReflectanceCsv(table), log);
    if (!o.png.empty())
        WriteText(o.png, ReflectanceChart(table, o.common.material, o.common.illuminant), log);
    return Finish(log, ColorTable(table));
}

}  // namespace

Outcome RunSpectrum(Args args) {
    return cli::RunWithOptions(args, "bsdftool spectrum", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::bsdftool
