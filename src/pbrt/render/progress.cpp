#include "pbrt/render/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <new>
#include <system_error>

#include "pbrt/util/say.h"

namespace pbrt {
namespace {

int64_t Now() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

int TerminalWidth() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

Progress::Progress(std::string title, bool quiet)
    : title(std::move(title)),
      quiet(quiet),
      terminal(isatty(STDERR_FILENO) != 0),
      startNanoseconds(Now()) {
    if (quiet || !terminal) return;
    try {
        thread = std::thread([this] { Run(); });
    } catch (const std::system_error &) {  // no thread to be had: the bar stands still
    }
}

Progress::~Progress() {
    if (!finished) Finish("stopped");
}

void Progress::Run() try {
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, std::chrono::milliseconds(200), [this] { return finished; }))
        Draw((Now() - startNanoseconds) * 1e-9);
} catch (const std::bad_alloc &) {  // no memory for a line: the bar stands still
}

void Progress::Draw(double seconds) const {
    const double fraction = double(done.load()) / std::max<int64_t>(1, total.load());
    const std::string times =
        fraction > 0 ? fmt::format("({:.1f}s|{:.1f}s)", seconds, seconds * (1 / fraction - 1))
                     : fmt::format("({:.1f}s|?s)", seconds);
    const int width = std::max(10, TerminalWidth() - int(title.size() + times.size()) - 7);
    const int filled = int(fraction * width);
    Say(fmt::format("\r{}: [{:+<{}}{: <{}}] {} ", title, "", filled, "", width - filled, times));
}

void Progress::Finish(const std::string &outcome) {
    {
        const std::lock_guard lock(mutex);
        finished = true;
    }
    wake.notify_all();
    if (thread.joinable()) thread.join();
    if (quiet) return;
    const double seconds = (Now() - startNanoseconds) * 1e-9;
    if (terminal) {
        Draw(seconds);
        Say("\n");
    }
    if (!terminal || outcome != "done")
        Say(fmt::format("{}: {} after {:.1f} s\n", title, outcome, seconds));
}

}  // namespace pbrt
