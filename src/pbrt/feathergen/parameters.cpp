#include "pbrt/feathergen/parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "pbrt/util/diagnostics.h"

namespace pbrt::feathergen {
namespace {

std::vector<std::string_view> ParameterNames() {
    std::vector<std::string_view> names;
    for (const FloatParam &row : ParameterTable())
        names.push_back(row.name);
    return names;
}

/// A value that is no number, for a message. Lists and objects by their kind alone: they can be
/// nested more deeply than a recursion may go.
std::string Describe(const nlohmann::json &value) {
    if (value.is_array() || value.is_object()) return fmt::format("an {}", value.type_name());
    constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
    return Shortened(value.dump(-1, ' ', false, kReplace));
}

std::string WithUnit(std::string_view text, std::string_view unit) {
    return unit.empty() ? std::string(text) : fmt::format("{} {}", text, unit);
}

}  // namespace

Parameters::Parameters() {
    for (const FloatParam &row : ParameterTable())
        this->*row.value = row.def;
}

std::string SetParameter(std::string_view name, double value, Parameters *parameters) {
    for (const FloatParam &row : ParameterTable()) {
        if (row.name != name) continue;
        if (!(value >= row.lo && value <= row.hi))
            return fmt::format("\"{}\" is {}, outside {}", name, value,
                               WithUnit(fmt::format("[{}, {}]", row.lo, row.hi), row.unit));
        if (row.whole && value != std::floor(value))
            return fmt::format("\"{}\" is {}, but it counts: expected a whole number", name, value);
        parameters->*row.value = value;
        return {};
    }
    return fmt::format("unknown parameter \"{}\"{}", Shortened(name),
                       DidYouMean(name, ParameterNames()));
}

Parameters PresetNamed(std::string_view name, std::string *problem) {
    Parameters parameters;
    std::vector<std::string_view> names;
    for (const Preset &preset : Presets()) {
        names.push_back(preset.name);
        if (preset.name != name) continue;
        for (const Preset::Change &change : preset.changes)
            parameters.*change.value = change.to;
        return parameters;
    }
    *problem = UnknownName("preset", name, names);
    return parameters;
}

std::string ParameterManual() {
    std::string text = "parameters for --set and --params (unit, range, default):\n";
    for (const FloatParam &row : ParameterTable())
        text += fmt::format("  {:<20}{:<5}{:<19}{:<8}{}\n", row.name, row.unit,
                            fmt::format("[{}, {}]", row.lo, row.hi), row.def, row.doc);
    text += "\npresets:\n";
    for (const Preset &preset : Presets())
        text += fmt::format("  {:<20}{}\n", preset.name, preset.doc);
    return text;
}

std::string ToJson(const Parameters &parameters) {
    nlohmann::ordered_json json;
    for (const FloatParam &row : ParameterTable())
        json[std::string(row.name)] = parameters.*row.value;
    return json.dump(2) + "\n";
}

std::string FromJson(std::string_view text, Parameters *parameters) {
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error &e) {
        return fmt::format("is not JSON: {}", Shortened(e.what(), 200));
    }
    if (!json.is_object()) return "expected a JSON object { \"name\": number, ... }";
    Parameters changed = *parameters;
    std::string mistakes;
    for (const auto &[name, value] : json.items()) {
        const std::string mistake =
            value.is_number()
                ? SetParameter(name, value.get<double>(), &changed)
                : fmt::format("\"{}\" is {}: expected a number", Shortened(name), Describe(value));
        if (mistake.empty()) continue;
        mistakes += (mistakes.empty() ? "" : "\n") + mistake;
    }
    if (mistakes.empty()) *parameters = changed;
    return mistakes;
}

}  // namespace pbrt::feathergen
