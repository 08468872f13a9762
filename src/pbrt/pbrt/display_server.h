#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "pbrt/render/render_state.h"
#include "pbrt/util/descriptor.h"
#include "pbrt/util/result.h"

namespace pbrt::program {

/// Shows a render in a viewer while it goes on: R, G and B, tile by tile as they get samples. A
/// thread of its own sends, so that a slow viewer holds nobody up; one that is gone, or takes
/// nothing for some seconds, is told of once and left alone.
class DisplayServer {
  public:
    /// Connects, waiting for some seconds at most. `address`: "host:port", "[::1]:port" or "host",
    /// for tev's port. `name`: of the picture. Film and state must outlive it. The reason where
    /// nobody listens there.
    static OrError<std::unique_ptr<DisplayServer>> Connect(const std::string &address,
                                                           const std::string &name,
                                                           const Film &film,
                                                           const RenderState &state);
    /// Sends what has not been sent.
    ~DisplayServer();
    DisplayServer(const DisplayServer &) = delete;
    DisplayServer &operator=(const DisplayServer &) = delete;

  private:
    DisplayServer(int socket, std::string address, std::string name, const Film &film,
                  const RenderState &state);
    void Run();
    /// False where nobody takes it.
    bool SendAll(std::string_view bytes);
    bool SendNews();
    bool SendTile(size_t tile, const Image &pixels);

    Descriptor socket;
    std::string address, name;
    const Film &film;
    const RenderState &state;
    std::vector<int> sent;  ///< by tile: how many samples were in it
    std::mutex mutex;
    std::condition_variable wake;
    bool ended = false;
    std::thread thread;
};

}  // namespace pbrt::program
