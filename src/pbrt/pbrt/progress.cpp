#include "pbrt/pbrt/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <system_error>

#include "pbrt/pbrt/messages.h"
#include "pbrt/util/say.h"

namespace pbrt::program {
namespace {

/// Erases the line that the cursor is in.
constexpr std::string_view kErase = "\r\033[K";

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

Progress::Progress(bool quiet) : quiet(quiet), terminal(!quiet && isatty(STDERR_FILENO) != 0) {
    if (!terminal) return;
    try {
        thread = std::thread([this] { Run(); });
    } catch (const std::system_error &) {  // no thread to be had: the line stands still
    }
}

Progress::~Progress() {
    Clear();
    {
        const std::lock_guard lock(mutex);
        ended = true;
    }
    wake.notify_all();
    if (thread.joinable()) thread.join();
}

void Progress::Run() try {
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, std::chrono::milliseconds(200), [this] { return ended; }))
        if (running) Draw();
} catch (const std::bad_alloc &) {  // no memory for a line: it stands still
}

void Progress::Begin(std::string name, std::function<Status()> status) {
    const std::lock_guard lock(mutex);
    title = std::move(name);
    ask = std::move(status);
    first = ask ? ask() : Status{};
    start = Now();
    running = true;
    if (terminal) Draw();
}

void Progress::Clear() {
    const std::lock_guard lock(mutex);
    if (running && terminal) Say(kErase);
    running = false;
    ask = {};
}

std::string Progress::BarText(double seconds) const {
    const Status now = ask();
    const double fraction = double(now.done) / double(std::max<int64_t>(1, now.total));
    const double doneNow = double(now.done - first.done), left = double(now.total - now.done);
    std::string text = fmt::format(
        "{:3.0f}% {:.{}f}/{} spp, {:.2f} Mrays/s, {}", std::floor(fraction * 100),
        fraction * now.samplesPerPixel, now.samplesPerPixel < 100 ? 1 : 0, now.samplesPerPixel,
        double(now.rays - first.rays) * 1e-6 / std::max(seconds, 1e-3), DurationText(seconds));
    if (doneNow > 0) text += fmt::format(", {} left", DurationText(seconds * left / doneNow));
    const int width = TerminalWidth() - int(title.size() + text.size()) - 7;
    if (width < 5) return text;
    const int filled = std::clamp(int(fraction * width), 0, width);
    return fmt::format("[{:+<{}}{: <{}}] {}", "", filled, "", width - filled, text);
}

void Progress::Draw() const {
    const double seconds = double(Now() - start) * 1e-9;
    Say(fmt::format("{}{}: {} ", kErase, title, ask ? BarText(seconds) : DurationText(seconds)));
}

void Progress::Finish(const std::string &outcome) {
    const double seconds = double(Now() - start) * 1e-9;
    Clear();
    if (!quiet && (!terminal || outcome != "done"))
        Say(fmt::format("{}: {} after {}\n", title, outcome, DurationText(seconds)));
}

}  // namespace pbrt::program
