#include "pbrt/pbrt/checkpointer.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "pbrt/pbrt/messages.h"
#include "pbrt/util/atomic_file.h"

namespace pbrt::program {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kMostOfTime = 1. / 50;

std::chrono::steady_clock::time_point After(double seconds) {
    constexpr double kLongest = 1e9;  // what a clock of 64 bits can count by far
    return std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(
               Seconds(std::min(seconds, kLongest)));
}

}  // namespace

Checkpointer::Checkpointer(const CheckpointOption &option, const RenderIdentity &identity,
                           const RenderState &state)
    : option(option), identity(identity), state(state), next(After(option.seconds)) {}

std::optional<std::string> Checkpointer::Write() const try {
    return WriteFileAtomically(option.file, MakeCheckpoint(identity, state));
} catch (const std::bad_alloc &) {
    return fmt::format("{}: cannot be written: memory has run out", option.file);
}

void Checkpointer::AfterPiece() {
    if (!Writes()) return;
    const std::unique_lock lock(mutex, std::try_to_lock);
    const Time start = std::chrono::steady_clock::now();
    if (!lock || start < next) return;
    const auto why = Write();
    if (why && !complained) {
        Warn(fmt::format("no checkpoint: {}; rendering goes on", *why));
        complained = true;
    }
    const Seconds took = std::chrono::steady_clock::now() - start;
    next = After(std::max(option.seconds, took.count() / kMostOfTime));
}

}  // namespace pbrt::program
