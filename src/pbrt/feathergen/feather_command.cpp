#include <fmt/format.h>

#include "pbrt/feathergen/feather_options.h"

namespace pbrt::feathergen {

Outcome Run(Args args) {
    const std::string help[] = {"--help"};
    if (args.empty()) return FeatherCommand(help);
    if (args[0] == "neck") return NeckCommand(args.subspan(1));
    if (args[0] != "help") return FeatherCommand(args);
    return args.size() > 1 && args[1] == "neck" ? NeckCommand(help) : FeatherCommand(help);
}

namespace {

constexpr char kDescription[] =
    "Grows a feather: meshes, textures and feather.pbrt, to be included in a scene. "
    "\"feathergen neck --help\": a neck covered with feathers.";

void DefineOptions(CLI::App *app, FeatherOptions *o) {
    o->AddTo(app);
}

Outcome WithOptions(FeatherOptions &o) {
    Parameters parameters;
    if (const std::string problem = o.Read(&parameters); !problem.empty()) return Failure(problem);
    if (o.printPreset) return {0, ToJson(parameters), {}};

    const Feather feather(parameters, o.seed);
    const FeatherNames names{o.Folder(), "feather-", o.Textures()};
    FileSet files;
    AddFeatherFiles(feather, names, &files);
    files.Add(names.folder + "feather.pbrt",
              TextWriter(fmt::format("# feathergen --preset {} --seed {}: root in the origin, tip "
                                     "along +y, outer face to +z, millimetres.\n{}"
                                     "AttributeBegin\n{}AttributeEnd\n",
                                     o.preset, o.seed, TextureDirectives(names),
                                     ShapeDirectives(parameters, names))));
    if (const auto problem = files.Write(names.folder)) return Failure(*problem);
    return {};
}

}  // namespace

Outcome FeatherCommand(Args args) {
    return cli::RunWithOptions(args, "feathergen", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::feathergen
