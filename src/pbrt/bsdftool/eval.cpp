#include <fmt/format.h>

#include "pbrt/bsdftool/command_line.h"
#include "pbrt/bsdftool/evaluation.h"
#include "pbrt/cli/options.h"

namespace pbrt::bsdftool {
namespace {

struct Options {
    CommonOptions common;
    std::string directions, wavelengths = "450,550,650", outfile;
    bool inDouble = false;
};

constexpr char kDescription[] =
    "Values of a material for pairs of directions, one JSON object a line: f in 1/sr without "
    "the cosine, pdf in 1/sr and, of featherbarbule, the gap fraction of wo and the parts R "
    "and TRT of f. The local frame has z along the normal; x runs across the barbules and y "
    "along them (\"rotation\" does not enter). The pdf of a featherbarbule is that of the "
    "first four wavelengths.";

void DefineOptions(CLI::App *app, Options *o) {
    AddMaterial(app, &o->common);
    cli::AddRequired(app, "--directions", &o->directions,
                     "CSV file with the header wo_x,wo_y,wo_z,wi_x,wi_y,wi_z");
    cli::AddText(app, "--wavelengths", &o->wavelengths, "in nm (default: 450,550,650)",
                 "nm,nm,...");
    cli::AddFlag(app, "--double", &o->inDouble,
                 "evaluate the model in double precision with a converged quadrature");
    cli::AddText(app, "--outfile", &o->outfile, "file for the lines (default: standard output)");
}

Outcome WithOptions(Options &o) {
    Diagnostics log;
    const auto source = ReadMaterial(o.common, log);
    const std::vector<DirectionPair> pairs = ReadDirections(o.directions, log);
    const std::vector<float> lambda =
        ReadNumbers(o.wavelengths, "--wavelengths", LambdaMin, LambdaMax, log);
    CheckWritable(o.outfile, log);
    if (source && o.inDouble && !HasOracle(source->material))
        log.Error({}, fmt::format("--double: material \"{}\" is written in float only; there is a "
                                  "double oracle of \"{}\" alone",
                                  source->type, FeatherBarbuleMaterial::kName));
    if (log.HasErrors()) return Finish(log);
    std::string lines;
    for (const DirectionPair &pair : pairs)
        lines += JsonLine(pair, lambda,
                          o.inDouble ? EvaluateOracle(source->material, pair, lambda)
                                     : Evaluate(source->material, pair, lambda)) +
                 "\n";
    if (o.outfile.empty()) return Finish(log, std::move(lines));
    WriteText(o.outfile, lines, log);
    return Finish(log);
}

}  // namespace

Outcome RunEval(Args args) {
    return cli::RunWithOptions(args, "bsdftool eval", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::bsdftool
