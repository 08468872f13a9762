#include "pbrt/util/write_all.h"

#include <fmt/format.h>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

namespace pbrt {
namespace {

/// While it lives the thread's own SIGXFSZ (and SIGPIPE) are held back; at its end they are
/// forgotten. Both go to the thread that writes, so that others are not concerned.
class HeldSignals {
  public:
    explicit HeldSignals(BrokenPipe brokenPipe) {
        sigset_t pending;
        sigpending(&pending);
        sigemptyset(&held);
        if (!sigismember(&pending, SIGXFSZ)) sigaddset(&held, SIGXFSZ);
        if (brokenPipe == BrokenPipe::Fails && !sigismember(&pending, SIGPIPE))
            sigaddset(&held, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &held, &before);
    }
    HeldSignals(const HeldSignals &) = delete;
    HeldSignals &operator=(const HeldSignals &) = delete;
    ~HeldSignals() {
        const timespec now{};
        while (sigtimedwait(&held, nullptr, &now) > 0)
            continue;
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
    }

  private:
    sigset_t held, before;
};

}  // namespace

int WriteAll(int fd, std::string_view bytes, BrokenPipe brokenPipe) {
    const HeldSignals signals(brokenPipe);
    while (!bytes.empty()) {
        const ssize_t n = write(fd, bytes.data(), bytes.size());
        if (n >= 0) {
            bytes.remove_prefix(size_t(n));
        } else if (errno == EAGAIN) {  // a pipe whose other end asked not to wait
            pollfd full{fd, POLLOUT, 0};
            poll(&full, 1, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

std::optional<std::string> WriteStandardOutput(std::string_view text) {
    const int error = WriteAll(STDOUT_FILENO, text, BrokenPipe::Kills);
    if (error == 0) return {};
    return fmt::format("standard output: cannot be written: {}", std::strerror(error));
}

}  // namespace pbrt
