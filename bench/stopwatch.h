#pragma once

#include <time.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pbrt::bench {

/// Seconds of this thread's processor time: other processes' share is not counted (POSIX; <chrono>
/// has no such clock).
inline double ThreadSeconds() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

/// Timings that are compared with each other: measured in turn, round by round, and the least of
/// each taken, so that all see the same quiet moments of the machine.
class Stopwatch {
  public:
    /// `run` makes `calls` calls and returns a number made of their results.
    void Add(const std::string &name, int calls, std::function<double()> run) {
        entries.push_back({name, calls, std::move(run), 1e30});
    }
    /// `passes`: runs of each in a round; the first of several warms the caches.
    void Run(int rounds, int passes = 1) {
        for (int r = 0; r < rounds; ++r)
            for (Entry &e : entries)
                for (int pass = 0; pass < passes; ++pass) {
                    const double start = ThreadSeconds();
                    sink = sink + e.run();
                    e.seconds = std::min(e.seconds, ThreadSeconds() - start);
                }
    }
    double Nanoseconds(const std::string &name) const {
        const auto e = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry &entry) { return entry.name == name; });
        return e->seconds * 1e9 / e->calls;
    }
    /// Names and nanoseconds of all, in the order they were added.
    std::vector<std::pair<std::string, double>> All() const {
        std::vector<std::pair<std::string, double>> all;
        for (const Entry &e : entries)
            all.emplace_back(e.name, e.seconds * 1e9 / e.calls);
        return all;
    }

  private:
    struct Entry {
        std::string name;
        int calls;
        std::function<double()> run;
        double seconds;
    };
    std::vector<Entry> entries;
    volatile double sink = 0;
};

}  // namespace pbrt::bench
