#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace pbrt::program {

/// Shows on standard error what a program is at, from its first moment on: on a terminal a line
/// that redraws itself, elsewhere nothing until the end. Written by hand because Debian packages no
/// library for it.
class Progress {
  public:
    /// `quiet`: shows nothing.
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// How far a render is.
    struct Status {
        int64_t done = 0, total = 0;  ///< samples of all pixels
        int samplesPerPixel = 0;      ///< when all are done
        int64_t rays = 0;
    };
    /// Begins a stage, "Parsing" or the like, which shows its time; with `ask`, which any thread
    /// must be able to call until the next stage, also a bar, per cent, samples, rays a second and
    /// the time left.
    void Begin(std::string title, std::function<Status()> ask = {});
    /// Ends the stage and takes its line away, so that other lines can follow.
    void Clear();
    /// Clears; says that the stage is `outcome`, as "done" or "stopped", where no terminal has
    /// shown it or it is not "done".
    void Finish(const std::string &outcome);

  private:
    void Run();
    void Draw() const;
    std::string BarText(double seconds) const;

    bool quiet, terminal;
    std::mutex mutex;  ///< for all below
    std::condition_variable wake;
    std::string title;
    std::function<Status()> ask;
    Status first;       ///< at the stage's start
    int64_t start = 0;  ///< ns
    bool running = false, ended = false;
    std::thread thread;
};

}  // namespace pbrt::program
