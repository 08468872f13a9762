#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace pbrt::test {

/// What a process is denied.
struct Limits {
    uint64_t addressSpace = 0;  ///< bytes, RLIMIT_AS; 0: no limit. Nothing for sanitizers
    int threads = 0;        ///< RLIMIT_NPROC, the first one too; 0: no limit. See CanLimitThreads
    std::string out = {};   ///< file that standard output goes to; empty: Outcome::said
    uint64_t fileSize = 0;  ///< bytes, RLIMIT_FSIZE; 0: no limit
    std::string err = {};   ///< as `out`, of standard error
    int ignored = 0;        ///< a signal that it starts with ignoring
};

/// How a process ended.
struct Outcome {
    int exitCode = -1;     ///< -1: by a signal, or because it took too long
    int signal = 0;        ///< that ended it
    bool tooLong = false;  ///< ended by Process
    std::string said;      ///< standard error and standard output, as they came
};

/// One of our programs, running in a folder with empty standard input. Ends with this object.
class Process {
  public:
    /// `program`: "pbrt", "imgtool" ..., or a path from the root.
    Process(const std::string &program, const std::vector<std::string> &args,
            const std::string &folder, const Limits &limits = {});
    ~Process();
    Process(const Process &) = delete;
    Process &operator=(const Process &) = delete;

    void Signal(int number) const;
    /// Waits until it has a handler for the signal; false where none comes.
    bool Catches(int number) const;
    /// Waits for its end; after `longest` it is killed.
    Outcome Wait(std::chrono::seconds longest = std::chrono::seconds(60));
    /// Whether it has said `text` within `longest`.
    bool Says(const std::string &text, std::chrono::seconds longest = std::chrono::seconds(20));

  private:
    /// Reads what is said until `until` or its end; whether the latter came.
    bool Read(std::chrono::steady_clock::time_point until);
    pid_t pid = -1;
    int output = -1;
    Outcome outcome;
};

/// A limit on threads counts those of the whole user; root has none, but can become a user that has
/// no other process. Whether that is so here.
bool CanLimitThreads();

}  // namespace pbrt::test
