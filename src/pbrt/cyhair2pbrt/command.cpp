#include "pbrt/cyhair2pbrt/command.h"

#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/cyhair2pbrt/hair_file.h"
#include "pbrt/util/atomic_file.h"
#include "pbrt/util/read_file.h"

namespace pbrt::cyhair2pbrt {
namespace {

struct Options {
    std::string in, out;
    int maxStrands = -1;
    float thickness = 1;
};

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "in.hair", &o->in, "hair file");
    cli::AddRequired(app, "out.pbrt", &o->out, "file to write; -: standard output");
    cli::AddNumber(app, "max_strands", &o->maxStrands, {}, "only the first; -1: all (default)");
    cli::AddNumber(app, "thickness", &o->thickness, {},
                   "of all curves (default 1); -1: what the file has");
}

cli::Outcome WithOptions(Options &o) {
    const FileContents file = ReadWholeFile(o.in, Pipes::Taken);
    if (!file.bytes) return cli::Failure("cyhair2pbrt", file.error);
    const OrError<HairFile> hair = ParseHair(*file.bytes);
    if (!hair) return cli::Failure("cyhair2pbrt", fmt::format("{}: {}", o.in, hair.error));
    const std::string text = CurvesOf(*hair.value, o.maxStrands, o.thickness);
    if (o.out == "-") return {0, text, {}};
    if (const auto why = WriteFileAtomically(o.out, text)) return cli::Failure("cyhair2pbrt", *why);
    return {};
}

}  // namespace

cli::Outcome Run(cli::Args args) {
    return cli::RunWithOptions(
        args, "cyhair2pbrt",
        "Turns a hair file (\"HAIR\", Cem Yuksel's format) into curves for a scene file.",
        DefineOptions, WithOptions);
}

}  // namespace pbrt::cyhair2pbrt
