#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace pbrt {

/// Shows how far a render is, on standard error: a bar with elapsed and remaining seconds that
/// redraws itself on a terminal; elsewhere one line at the end. Written by hand because Debian
/// packages no library for it.
class Progress {
  public:
    /// `quiet`: shows nothing.
    Progress(std::string title, bool quiet);
    ~Progress();
    /// Any thread, as often as it likes.
    void Update(int64_t done, int64_t total) {
        this->total.store(total, std::memory_order_relaxed);
        this->done.store(done, std::memory_order_relaxed);
    }
    /// Draws the last state and ends the line. `outcome` as in "done" or "stopped".
    void Finish(const std::string &outcome);

  private:
    void Run();
    void Draw(double seconds) const;
    std::string title;
    bool quiet, terminal;
    std::atomic<int64_t> done{0}, total{1};
    int64_t startNanoseconds;
    std::mutex mutex;
    std::condition_variable wake;
    bool finished = false;
    std::thread thread;
};

}  // namespace pbrt
