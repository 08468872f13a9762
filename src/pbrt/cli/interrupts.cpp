#include "pbrt/cli/interrupts.h"

#include <array>
#include <csignal>

namespace pbrt::cli {
namespace {

constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing else.
volatile std::sig_atomic_t caught = 0;

void SetAll(void (*handler)(int)) {
    for (int number : kSignals) {
        struct sigaction action {};
        if (sigaction(number, nullptr, &action) != 0) continue;
        if (number == SIGHUP && action.sa_handler == SIG_IGN) continue;
        action = {};
        action.sa_handler = handler;  // without SA_RESTART
        sigaction(number, &action, nullptr);
    }
}

void Note(int number) {
    caught = number;
    SetAll(SIG_DFL);
}

}  // namespace

Interrupts::Interrupts() {
    caught = 0;
    SetAll(Note);
}

Interrupts::~Interrupts() {
    SetAll(SIG_DFL);
}

std::optional<Interrupts::Caught> Interrupts::First() const {
    const int number = caught;
    if (number == 0) return {};
    return Caught{number == SIGINT    ? "SIGINT"
                  : number == SIGTERM ? "SIGTERM"
                                      : "SIGHUP",
                  128 + number};
}

}  // namespace pbrt::cli
