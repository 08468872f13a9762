#include "pbrt/cli/tool.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "pbrt/cli/help.h"
#include "pbrt/cli/main.h"
#include "pbrt/util/args.h"
#include "pbrt/util/upstream.h"
#include "pbrt/util/write_all.h"

namespace pbrt::cli {
namespace {

constexpr size_t kLongestMessage = 10000;

std::string Manual(const Tool &tool) {
    std::string text = fmt::format("usage: {} {}\n\n", tool.name, tool.usage);
    size_t width = 0;
    for (const Command &command : tool.commands)
        width = std::max(width, command.name.size());
    for (const Command &command : tool.commands)
        text += fmt::format("  {:<{}}{}\n", command.name, width + 2, command.summary);
    return text +
           fmt::format("\n\"{} help <command>\" lists the options of a command.\n", tool.name);
}

Outcome UnknownCommand(const Tool &tool, std::string_view name) {
    std::vector<std::string_view> names;
    for (const Command &command : tool.commands)
        names.push_back(command.name);
    const std::string upstream = PbrtHasIt(fmt::format("command of {}", tool.name), name);
    return Failure(tool.name,
                   fmt::format("unknown command \"{}\"{}\nexpected {}", Shortened(name),
                               upstream.empty() ? DidYouMean(name, names) : "; " + upstream,
                               QuotedList(names)));
}

std::string Version() {
    return "pbrt-feather " PBRT_VERSION;
}

/// The last of an option given twice counts: wrappers append theirs.
void LastOnesCount(CLI::App *app) {
    for (CLI::Option *option : app->get_options([](CLI::Option *) { return true; }))
        if (!option->get_positional() && option->get_items_expected_max() == 1)
            option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

/// Something is returned where the command ends here: help, the version, or a mistake.
std::optional<Outcome> Parse(CLI::App *app, Args args) {
    app->set_help_flag("--help", "print this");
    app->set_version_flag("--version", Version(), "print the version");
    const std::string footer = app->get_footer();
    app->footer(fmt::format("{}{}{}\n", footer, footer.empty() ? "" : "\n", kMemoryLimitHelp));
    LastOnesCount(app);
    NormalizedArgs normalized = NormalizeArgs(args, ArgOptionsOf(*app));
    const auto mistake = [&](std::string_view text) {
        return Outcome{1,
                       {},
                       fmt::format("{}: {}\n(\"{} --help\" lists the options)\n", app->get_name(),
                                   Shortened(text, kLongestMessage), app->get_name())};
    };
    const std::string upstream =
        PbrtHasIt(fmt::format("option of {}", app->get_name()), normalized.unknown);
    if (!upstream.empty())
        return mistake("unknown option --" + normalized.unknown + "; " + upstream);
    if (!normalized.error.empty()) return mistake(normalized.error);
    std::reverse(normalized.args.begin(), normalized.args.end());  // CLI11 takes them from the back
    try {
        app->parse(normalized.args);
    } catch (const CLI::CallForHelp &) {
        return Outcome{0, Help(*app), {}};
    } catch (const CLI::CallForVersion &e) {
        return Outcome{0, std::string(e.what()) + "\n", {}};
    } catch (const CLI::ParseError &e) {
        return mistake(e.what());
    }
    return {};
}

}  // namespace

Outcome Run(const Tool &tool, Args args) {
    if (!args.empty() && (args[0] == "--version" || args[0] == "-version"))
        return {0, Version() + "\n", {}};
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

Outcome RunWithOptions(Args args, const std::string &name, const std::string &description,
                       const std::function<void(CLI::App *app)> &define,
                       const std::function<Outcome()> &run) {
    CLI::App app(description, name);
    define(&app);
    if (std::optional<Outcome> end = Parse(&app, args)) return *std::move(end);
    return run();
}

Outcome Finish(const Diagnostics &log, std::string out) {
    Outcome outcome;
    for (const Message &m : log.Messages())
        outcome.err +=
            fmt::format("{}: {}\n", m.severity == Severity::Error ? "Error" : "Warning", m.text);
    if (log.HasErrors())
        outcome.exitCode = 1;
    else
        outcome.out = std::move(out);
    return outcome;
}

int Print(const Outcome &outcome) {
    std::fputs(outcome.err.c_str(), stderr);
    const auto why = WriteStandardOutput(outcome.out);
    if (!why) return outcome.exitCode;
    std::fprintf(stderr, "%s\n", why->c_str());
    return std::max(outcome.exitCode, 1);
}

}  // namespace pbrt::cli
