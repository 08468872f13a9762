#include "pbrt/feathergen/feather_options.h"

#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/util/diagnostics.h"
#include "pbrt/util/parse_number.h"
#include "pbrt/util/read_file.h"

namespace pbrt::feathergen {
namespace {

/// All parameters take some 1.5 kB; parsed, JSON takes up to a hundred times its size.
constexpr uint64_t kMostJsonBytes = 1000000;

/// `name=value`.
std::string ApplySetting(const std::string &setting, Parameters *parameters) {
    const size_t equals = setting.find('=');
    if (equals != std::string::npos)
        if (const auto value = ParseNumber(std::string_view(setting).substr(equals + 1)))
            return SetParameter(setting.substr(0, equals), *value, parameters);
    return fmt::format("\"{}\": expected name=number", Shortened(setting));
}

}  // namespace

void FeatherOptions::AddTo(CLI::App *app) {
    cli::AddText(app, "--preset", &preset, "where parameters start from (default rock-dove-neck)");
    cli::AddText(app, "--params", &paramsFile,
                 "JSON file of parameters, as --print-preset writes it");
    cli::AddRepeated(app, "--set", &set, "name=value: one parameter; may be repeated");
    cli::AddNumber(app, "--seed", &seed, cli::kFromZero,
                   "another feather of the same kind (default 0)");
    cli::AddText(app, "--out", &out, "folder to write to; the scene names files as given here");
    cli::AddText(
        app, "--textures", &textures,
        "atlas (EXR pictures, default) or ptex: how values that vary over the vane are kept");
    cli::AddFlag(app, "--print-preset", &printPreset, "print the parameters as JSON and end");
    cli::AddFooter(app, ParameterManual());
}

std::string FeatherOptions::Read(Parameters *parameters) const {
    std::string problem;
    *parameters = PresetNamed(preset, &problem);
    if (!problem.empty()) return "--preset: " + problem;
    if (!paramsFile.empty()) {
        const FileContents file = ReadWholeFile(paramsFile, Pipes::Taken, kMostJsonBytes);
        if (!file.bytes) return "--params: " + file.error;
        problem = FromJson(*file.bytes, parameters);
        if (!problem.empty()) return fmt::format("--params: {}: {}", paramsFile, problem);
    }
    for (const std::string &setting : set) {
        problem = ApplySetting(setting, parameters);
        if (!problem.empty()) return "--set: " + problem;
    }
    if (parameters->VaneQuads() > kMostVaneQuads)
        return fmt::format(
            "barb_count, quads_along and quads_across make {:.0f} quads a feather, "
            "above {:.0f}",
            parameters->VaneQuads(), kMostVaneQuads);
    constexpr std::string_view kKinds[] = {"atlas", "ptex"};
    if (textures != "atlas" && textures != "ptex")
        return "--textures: " + UnknownName("kind", textures, kKinds);
    if (out.empty() && !printPreset) return "--out is missing: expected a folder to write to";
    if (out.find('"') != std::string::npos)
        return fmt::format("--out: \"{}\": scenes cannot name a folder with a quotation mark",
                           Shortened(out));
    return {};
}

TextureFiles FeatherOptions::Textures() const {
    return textures == "ptex" ? TextureFiles::Ptex : TextureFiles::Atlas;
}

std::string FeatherOptions::Folder() const {
    return out.ends_with('/') ? out : out + "/";
}

}  // namespace pbrt::feathergen
