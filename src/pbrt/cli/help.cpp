#include "pbrt/cli/help.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

namespace pbrt::cli {
namespace {

constexpr size_t kWidth = 100, kIndent = 32;

/// The words of `text` in lines; the first line begins in column `column`, others in `indent`.
std::string Wrapped(std::string_view text, size_t column, size_t indent) {
    std::string lines;
    bool first = true;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (!first && column + 1 + word.size() > kWidth) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (!first) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += word.size();
        first = false;
    }
    return lines;
}

std::string Row(const std::string &name, const CLI::Option &option) {
    std::string row = "  " + name;
    if (option.get_items_expected_max() > 0 && !option.get_positional())
        row += " " + option.get_type_name();
    const std::string required =
        option.get_required() && !option.get_positional() ? "required: " : "";
    row += row.size() + 2 > kIndent ? '\n' + std::string(kIndent, ' ')
                                    : std::string(kIndent - row.size(), ' ');
    return row + Wrapped(required + option.get_description(), kIndent, kIndent) + '\n';
}

/// As it is written: `picture`, `[files...]`.
std::string Usage(const CLI::Option &positional) {
    std::string name = positional.get_name(true);
    if (positional.get_items_expected_max() > 1) name += "...";
    return positional.get_required() ? name : '[' + name + ']';
}

}  // namespace

std::string Help(const CLI::App &app) {
    std::string usage = fmt::format("usage: {} [options]", app.get_name()), arguments, options;
    for (const CLI::Option *option : app.get_options()) {
        if (option->get_positional()) {
            usage += " " + Usage(*option);
            arguments += Row(option->get_name(true), *option);
        } else {
            options += Row("--" + option->get_lnames().at(0), *option);
        }
    }
    std::string text = usage + "\n\n" + Wrapped(app.get_description(), 0, 0) + "\n";
    if (!arguments.empty()) text += "\narguments:\n" + arguments;
    text += "\noptions:\n" + options;
    const std::string footer = app.get_footer();
    return footer.empty() ? text : text + '\n' + footer;
}

}  // namespace pbrt::cli
