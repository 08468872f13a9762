#include "pbrt/util/args.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "pbrt/util/diagnostics.h"

namespace pbrt {
namespace {

bool IsOption(std::string_view word) {
    if (word.size() < 2 || word[0] != '-') return false;
    const unsigned char second = word[1];
    return !std::isdigit(second) && second != '.';
}

std::string CanonicalName(std::string_view spelled) {
    std::string name;
    for (const unsigned char c : spelled)
        if (c != '-' && c != '_') name += char(std::tolower(c));
    return name == "h" ? "help" : name;
}

std::string UnknownOption(std::string_view spelled, const std::string &name,
                          std::span<const ArgOption> options) {
    std::vector<std::string_view> known;
    for (const ArgOption &option : options)
        known.push_back(option.name);
    const std::string_view nearest = NearestName(name, known);
    return fmt::format("unknown option {}{}", spelled,
                       nearest.empty() ? "" : fmt::format("; did you mean --{}?", nearest));
}

}  // namespace

bool IsSpellingOf(std::string_view spelled, std::string_view name) {
    return IsOption(spelled) && CanonicalName(spelled) == CanonicalName(name);
}

NormalizedArgs NormalizeArgs(std::span<const std::string> args,
                             std::span<const ArgOption> options) {
    NormalizedArgs normalized;
    for (size_t i = 0; i < args.size(); ++i) {
        const std::string &word = args[i];
        if (word == "--") {
            normalized.args.insert(normalized.args.end(), args.begin() + i, args.end());
            break;
        }
        if (!IsOption(word)) {
            normalized.args.push_back(word);
            continue;
        }
        const size_t equals = word.find('=');
        const std::string spelled = word.substr(0, equals);
        const std::string name = CanonicalName(spelled);
        const auto option = std::find_if(options.begin(), options.end(), [&](const ArgOption &o) {
            return CanonicalName(o.name) == name;
        });
        if (option == options.end()) {
            normalized.error = UnknownOption(spelled, name, options);
            normalized.unknown = name;
            return normalized;
        }
        std::string value;
        if (equals != std::string::npos)
            value = word.substr(equals + 1);
        else if (option->takesValue && i + 1 < args.size())
            value = args[++i];
        if (value.empty() && (option->takesValue || equals != std::string::npos)) {
            normalized.error = fmt::format("option {} needs a value", spelled);
            return normalized;
        }
        normalized.args.push_back("--" + option->name + (value.empty() ? "" : "=" + value));
    }
    return normalized;
}

}  // namespace pbrt
