#pragma once

#include <optional>
#include <string>

namespace pbrt::cli {

/// Number of threads that a program may use.
struct Threads {
    int count = 1;  ///< with the calling one
    /// Why they are fewer than wanted, as in "only 3 threads of 8 can be started: Resource
    /// temporarily unavailable".
    std::optional<std::string> remark;
};

/// Lets oneTBB, and through it the ray tracer, use as many threads as are wanted (0: one for each
/// core) and can be had, at most one for each core. Both end the program where a thread cannot be
/// started, as under `ulimit -u`, and crash where 1e5 are asked for; so threads are tried first. To
/// be called once, before other threads are started; it holds until the program ends.
Threads LimitThreads(int wanted);

}  // namespace pbrt::cli
