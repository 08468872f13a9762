#include "pbrt/pbrt/messages.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "pbrt/util/say.h"
#include "pbrt/util/write_all.h"

namespace pbrt::program {

int Complain(std::string_view why) {
    Say(fmt::format("Error: {}\n", why));
    return kUserError;
}

void Warn(std::string_view what) {
    Say(fmt::format("Warning: {}\n", what));
}

int PrintOut(std::string_view text) {
    const auto why = WriteStandardOutput(text);
    return why ? Complain(*why) : kSuccess;
}

void Print(const Diagnostics &log, bool quiet) {
    constexpr size_t kMost = 50;
    const bool color = isatty(STDERR_FILENO) != 0;
    const bool errorsOnly = quiet || (log.HasErrors() && log.Messages().size() > kMost);
    size_t shown = 0, more = 0;
    for (const Message *m : log.InOrderOfPlace()) {
        const bool error = m->severity == Severity::Error;
        if (quiet && !error) continue;
        if ((errorsOnly && !error) || shown == kMost) {
            ++more;
            continue;
        }
        ++shown;
        Say(fmt::format("{}{}{}: {}\n", color ? (error ? "\033[1;31m" : "\033[1;33m") : "",
                        error ? "Error" : "Warning", color ? "\033[0m" : "", m->text));
    }
    if (more > 0) Say(fmt::format("... and {} more messages.\n", more));
    for (const std::string &line : log.MissingFiles())
        Say(line + ".\n");
}

std::string DurationText(double seconds) {
    if (seconds < 0.1) return fmt::format("{:.2f} s", seconds);
    if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
    const auto whole = int64_t(std::lround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace pbrt::program
