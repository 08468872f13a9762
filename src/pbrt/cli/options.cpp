#include "pbrt/cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "pbrt/util/diagnostics.h"

namespace pbrt::cli {

std::string InWords(const Domain &d) {
    const bool low = std::isfinite(d.lo), high = std::isfinite(d.hi);
    if (low && high)
        return fmt::format(" {} {} {} {}", d.above ? "above" : "from", d.lo,
                           d.above ? "and at most" : "to", d.hi);
    if (low) return fmt::format(" {} {}", d.above ? "above" : "of at least", d.lo);
    return high ? fmt::format(" of at most {}", d.hi) : std::string();
}

std::string InSigns(const Domain &d) {
    const bool low = std::isfinite(d.lo), high = std::isfinite(d.hi);
    if (low && high) return fmt::format(" in {}{}, {}]", d.above ? '(' : '[', d.lo, d.hi);
    if (low) return fmt::format(" {} {}", d.above ? ">" : ">=", d.lo);
    return high ? fmt::format(" <= {}", d.hi) : std::string();
}

void Refuse(const std::string &option, const std::string &wanted, const std::string &text) {
    throw CLI::ValidationError(option,
                               fmt::format("expected {}, found {}", wanted, Shortened(text)));
}

CLI::Option *AddWord(CLI::App *app, const std::string &option,
                     std::function<void(const std::string &word)> read, const std::string &doc,
                     const std::string &form) {
    return app->add_option_function<std::string>(option, std::move(read), doc)->type_name(form);
}

CLI::Option *AddText(CLI::App *app, const std::string &option, std::string *value,
                     const std::string &doc, const std::string &form) {
    return app->add_option(option, *value, doc)->type_name(form);
}

void AddRequired(CLI::App *app, const std::string &option, std::string *value,
                 const std::string &doc) {
    app->add_option(option, *value, doc)->required();
}

void AddRequired(CLI::App *app, const std::string &argument, std::vector<std::string> *values,
                 const std::string &doc) {
    app->add_option(argument, *values, doc)->required();
}

void AddTexts(CLI::App *app, const std::string &argument, std::vector<std::string> *values,
              const std::string &doc) {
    app->add_option(argument, *values, doc);
}

void AddRepeated(CLI::App *app, const std::string &option, std::vector<std::string> *values,
                 const std::string &doc, const std::string &form) {
    app->add_option(option, *values, doc)->allow_extra_args(false)->type_name(form);
}

void AddFlag(CLI::App *app, const std::string &option, bool *value, const std::string &doc) {
    app->add_flag(option, *value, doc);
}

void Exclude(CLI::Option *option, CLI::Option *other) {
    option->excludes(other);
}

void AddFooter(CLI::App *app, const std::string &text) {
    app->footer(text);
}

std::vector<std::string> SplitList(const std::string &text) {
    std::vector<std::string> words{""};
    for (const char c : text)
        if (c == ',')
            words.emplace_back();
        else
            words.back() += c;
    return words;
}

CLI::Option *AddNames(CLI::App *app, const std::string &option, std::vector<std::string> *names,
                      const std::string &parts, const std::string &doc) {
    const auto read = [=](const std::string &text) {
        const std::vector<std::string> words = SplitList(text);
        if (std::find(words.begin(), words.end(), "") != words.end())
            Refuse(option, fmt::format("names such as {}", parts), text);
        *names = words;
    };
    return AddWord(app, option, read, doc, parts);
}

CLI::Option *AddChoice(CLI::App *app, const std::string &option, std::string *value,
                       std::initializer_list<std::string_view> allowed, const std::string &doc) {
    const std::vector<std::string_view> names(allowed);
    const auto read = [=](const std::string &text) {
        if (std::find(names.begin(), names.end(), text) == names.end())
            Refuse(option, QuotedList(names), text + DidYouMean(text, names));
        *value = text;
    };
    return AddWord(app, option, read, doc, fmt::format("{}", fmt::join(names, "|")));
}

}  // namespace pbrt::cli
