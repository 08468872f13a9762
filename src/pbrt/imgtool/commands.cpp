#include "pbrt/imgtool/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "pbrt/imgtool/command_line.h"
#include "pbrt/util/diagnostics.h"

namespace pbrt::imgtool {
namespace {

constexpr std::array kCommands{
    Command{"average", "mean of several pictures, and its variance", Average},
    Command{"check", "test that a picture is finite, not black, and changes its hue", Check},
    Command{"convert", "change a picture's format, size, colors or values", Convert},
    Command{"diff", "compare a picture with a reference", Diff},
    Command{"error", "expected error of one of several independent renderings", Error},
    Command{"info", "size, metadata and range of values", Info},
    Command{"makeequiarea", "latitude-longitude environment to a square equal-area one",
            MakeEquiArea},
};

std::string Manual() {
    std::string text = "usage: imgtool <command> [options] files...\n\n";
    for (const Command &command : kCommands)
        text += fmt::format("  {:<14}{}\n", command.name, command.summary);
    return text + "\n\"imgtool help <command>\" lists the options of a command.\n";
}

const Command *Find(std::string_view name) {
    const auto found = std::find_if(kCommands.begin(), kCommands.end(),
                                    [&](const Command &c) { return c.name == name; });
    return found == kCommands.end() ? nullptr : &*found;
}

Outcome Unknown(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Command &command : kCommands)
        names.push_back(command.name);
    return Failure(fmt::format("unknown command \"{}\"{}\nexpected {}", name,
                               DidYouMean(name, names), QuotedList(names)));
}

}  // namespace

std::span<const Command> Commands() {
    return kCommands;
}

Outcome Run(Args args) {
    const bool wantsHelp = args.empty() || args[0] == "help" || args[0] == "--help" ||
                           args[0] == "-help" || args[0] == "-h";
    if (wantsHelp && args.size() < 2) return {0, Manual(), {}};
    const std::string &name = args[wantsHelp ? 1 : 0];
    const Command *command = Find(name);
    if (!command) return Unknown(name);
    const std::string help[] = {"--help"};
    return command->run(wantsHelp ? Args(help) : args.subspan(1));
}

}  // namespace pbrt::imgtool
