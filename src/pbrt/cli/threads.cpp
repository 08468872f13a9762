#include "pbrt/cli/threads.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace pbrt::cli {
namespace {

/// Threads that wait until all are there.
class Trial {
  public:
    explicit Trial(int wanted) {
        started.reserve(size_t(wanted));
        try {
            while (int(started.size()) + 1 < wanted)
                started.emplace_back([this] { Wait(); });
        } catch (const std::system_error &e) {
            why = e.code().message();
        }
    }
    ~Trial() {
        {
            const std::lock_guard lock(mutex);
            open = true;
        }
        gate.notify_all();
        for (std::thread &thread : started)
            thread.join();
    }
    int Count() const { return int(started.size()) + 1; }
    const std::string &Why() const { return why; }

  private:
    void Wait() {
        std::unique_lock lock(mutex);
        gate.wait(lock, [this] { return open; });
    }
    std::mutex mutex;
    std::condition_variable gate;
    bool open = false;
    std::vector<std::thread> started;
    std::string why;
};

}  // namespace

Threads LimitThreads(int wanted) {
    const int cores = tbb::info::default_concurrency();
    Threads threads{wanted > 0 ? std::min(wanted, cores) : cores, {}};
    if (wanted > cores)
        threads.remark =
            fmt::format("{} threads are asked for, {} are used: one for each core", wanted, cores);
    const Trial trial(threads.count);
    if (trial.Count() < threads.count)
        threads.remark = fmt::format("only {} thread{} of {} can be started: {}", trial.Count(),
                                     trial.Count() == 1 ? "" : "s", threads.count, trial.Why());
    threads.count = trial.Count();
    // Never destroyed, for then oneTBB would start threads again.
    alignas(tbb::global_control) static std::byte limit[sizeof(tbb::global_control)];
    new (limit)
        tbb::global_control(tbb::global_control::max_allowed_parallelism, size_t(threads.count));
    return threads;
}

}  // namespace pbrt::cli
