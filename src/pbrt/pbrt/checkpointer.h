#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "pbrt/pbrt/command_line.h"
#include "pbrt/render/checkpoint.h"

namespace pbrt::program {

/// Writes checkpoints of a render to a file, all or nothing; where one fails the older stays.
class Checkpointer {
  public:
    /// No file: nothing is written. `state` must outlive it.
    Checkpointer(const CheckpointOption &option, const RenderIdentity &identity,
                 const RenderState &state);

    bool Writes() const { return !option.file.empty(); }
    const std::string &File() const { return option.file; }
    /// Writes where it is time for it, by the thread that calls; others that call meanwhile pass
    /// by. The first failure is told, and the render goes on. However often checkpoints are wanted,
    /// they take at most 1/50 of a thread's time.
    void AfterPiece();
    /// Writes now; the reason where that fails.
    std::optional<std::string> Write() const;

  private:
    using Time = std::chrono::steady_clock::time_point;
    CheckpointOption option;
    const RenderIdentity &identity;
    const RenderState &state;
    std::mutex mutex;  ///< for all below; held while one is written
    Time next;
    bool complained = false;
};

}  // namespace pbrt::program
