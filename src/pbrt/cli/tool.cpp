#include "pbrt/cli/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "pbrt/cli/main.h"
#include "pbrt/util/args.h"
#include "pbrt/util/diagnostics.h"
#include "pbrt/util/write_all.h"

namespace pbrt::cli {
namespace {

constexpr size_t kLongestMessage = 10000;

std::string Manual(const Tool &tool) {
    std::string text = fmt::format("usage: {} {}\n\n", tool.name, tool.usage);
    for (const Command &command : tool.commands)
        text += fmt::format("  {:<14}{}\n", command.name, command.summary);
    return text +
           fmt::format("\n\"{} help <command>\" lists the options of a command.\n", tool.name);
}

Outcome UnknownCommand(const Tool &tool, std::string_view name) {
    std::vector<std::string_view> names;
    for (const Command &command : tool.commands)
        names.push_back(command.name);
    return Failure(tool.name, fmt::format("unknown command \"{}\"{}\nexpected {}", Shortened(name),
                                          DidYouMean(name, names), QuotedList(names)));
}

/// The first number option that is not a number, which a range would let pass; or nothing.
std::string NaNOption(const CLI::App &app) {
    for (const CLI::Option *option : app.get_options()) {
        if (option->get_type_name().find("FLOAT") == std::string::npos) continue;
        for (const std::string &word : option->results())
            if (std::isnan(std::strtod(word.c_str(), nullptr)))
                return fmt::format("{}: {} is no number", option->get_name(), Shortened(word));
    }
    return {};
}

}  // namespace

Outcome Run(const Tool &tool, Args args) {
    const bool wantsHelp = args.empty() || args[0] == "help" || args[0] == "--help" ||
                           args[0] == "-help" || args[0] == "-h";
    if (wantsHelp && args.size() < 2) return {0, Manual(tool), {}};
    const std::string &name = args[wantsHelp ? 1 : 0];
    const auto command = std::find_if(tool.commands.begin(), tool.commands.end(),
                                      [&](const Command &c) { return c.name == name; });
    if (command == tool.commands.end()) return UnknownCommand(tool, name);
    const std::string help[] = {"--help"};
    return command->run(wantsHelp ? Args(help) : args.subspan(1));
}

Outcome Failure(std::string_view tool, std::string_view reason) {
    return {1, {}, fmt::format("{}: {}\n", tool, Shortened(reason, kLongestMessage))};
}

std::optional<Outcome> Parse(CLI::App *app, Args args) {
    const std::string footer = app->get_footer();
    app->footer(fmt::format("{}{}{}", footer, footer.empty() ? "" : "\n", kMemoryLimitHelp));
    NormalizedArgs normalized = NormalizeArgs(args, ArgOptionsOf(*app));
    const auto mistake = [&](std::string_view text) {
        return Outcome{1,
                       {},
                       fmt::format("{}: {}\n(\"{} --help\" lists the options)\n", app->get_name(),
                                   Shortened(text, kLongestMessage), app->get_name())};
    };
    if (!normalized.error.empty()) return mistake(normalized.error);
    std::reverse(normalized.args.begin(), normalized.args.end());  // CLI11 takes them from the back
    try {
        app->parse(normalized.args);
    } catch (const CLI::CallForHelp &) {
        return Outcome{0, app->help(), {}};
    } catch (const CLI::ParseError &e) {
        return mistake(e.what());
    }
    if (const std::string wrong = NaNOption(*app); !wrong.empty()) return mistake(wrong);
    return {};
}

int Print(const Outcome &outcome) {
    std::fputs(outcome.err.c_str(), stderr);
    const auto why = WriteStandardOutput(outcome.out);
    if (!why) return outcome.exitCode;
    std::fprintf(stderr, "%s\n", why->c_str());
    return std::max(outcome.exitCode, 1);
}

}  // namespace pbrt::cli
