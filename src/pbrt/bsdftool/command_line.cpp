#include "pbrt/bsdftool/command_line.h"

#include <fmt/format.h>

#include "pbrt/bsdftool/csv.h"
#include "pbrt/cli/options.h"
#include "pbrt/util/atomic_file.h"

namespace pbrt::bsdftool {
namespace {

constexpr std::string_view kEqualEnergy = "equal-energy";

}  // namespace

void AddMaterial(CLI::App *app, CommonOptions *o) {
    cli::AddRequired(
        app, "MATERIAL", &o->material,
        "pbrt text such as 'Material \"featherbarbule\" \"float thickness\" 595', or a "
        "scene file, whose first material is taken");
    cli::AddText(app, "--pick", &o->pick,
                 "take the first material of this name or type, not the first of all");
}

void AddIlluminant(CLI::App *app, CommonOptions *o) {
    cli::AddText(app, "--illuminant", &o->illuminant,
                 "named spectrum of the light, e.g. stdillum-D65 (default: equal-energy)");
}

std::optional<MaterialSource> ReadMaterial(const CommonOptions &o, Diagnostics &log) {
    return ReadMaterial(o.material, o.pick, log);
}

Spectrum ReadIlluminant(const CommonOptions &o, Diagnostics &log) {
    if (o.illuminant == kEqualEnergy) return Spectrum(1);
    if (const Spectrum *named = GetNamedSpectrum(o.illuminant)) return *named;
    std::vector<std::string_view> known{kEqualEnergy};
    for (std::string_view name : NamedSpectrumNames())
        if (name.find("illum") != std::string_view::npos) known.push_back(name);
    log.Error({}, UnknownName("illuminant", o.illuminant, known));
    return Spectrum(1);
}

std::vector<float> ReadNumbers(std::string_view text, std::string_view what, float lo, float hi,
                               Diagnostics &log) {
    std::vector<float> numbers;
    for (std::string_view cell : SplitCells(text, ',')) {
        const std::optional<double> value = ReadNumber(cell);
        if (!value)
            log.Error({}, fmt::format("{}: \"{}\" is not a number", what, cell));
        else if (!(*value >= lo && *value <= hi))
            log.Error({}, fmt::format("{}: {:g} is outside [{:g}, {:g}]", what, *value, lo, hi));
        else
            numbers.push_back(float(*value));
    }
    return numbers;
}

void CheckWritable(const std::string &fileName, Diagnostics &log) {
    if (fileName.empty()) return;
    if (const auto why = WhyNotWritable(fileName)) log.Error({}, *why);
}

void WriteText(const std::string &fileName, std::string_view text, Diagnostics &log) {
    if (fileName.empty()) return;
    if (const auto why = WriteFileAtomically(fileName, text)) log.Error({}, *why);
}

}  // namespace pbrt::bsdftool
