#include "pbrt/pbrt/display_server.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>

#include "pbrt/pbrt/messages.h"
#include "pbrt/pbrt/tev_packets.h"
#include "pbrt/util/parse_number.h"

namespace pbrt::program {
namespace {

constexpr int kPatienceMilliseconds = 5000;
constexpr std::chrono::milliseconds kBetweenUpdates(250);
constexpr std::array<std::string_view, 3> kChannels{"R", "G", "B"};

struct Address {
    std::string host, port = std::to_string(tev::kPort);
};

/// nullopt where `text` is none.
std::optional<Address> ParseAddress(const std::string &text) {
    Address a;
    size_t colon = text.rfind(':');
    if (text.starts_with('[')) {
        const size_t end = text.find(']');
        if (end == text.npos) return {};
        a.host = text.substr(1, end - 1);
        colon = end + 1 < text.size() ? end + 1 : text.npos;
        if (colon != text.npos && text[colon] != ':') return {};
    } else {
        a.host = text.substr(0, colon);
    }
    if (colon != text.npos) a.port = text.substr(colon + 1);
    const auto port = ParseWhole<int>(a.port);
    if (a.host.empty() || !port || *port < 1 || *port > 65535) return {};
    return a;
}

bool WaitFor(int fd, short what) {
    pollfd p{fd, what, 0};
    int n;
    do
        n = poll(&p, 1, kPatienceMilliseconds);
    while (n < 0 && errno == EINTR);
    return n > 0;
}

/// A socket that does not wait; -1 and errno where it cannot be had.
int ConnectTo(const addrinfo &to) {
    const int fd = ::socket(to.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd < 0) return -1;
    int error = 0;
    if (connect(fd, to.ai_addr, to.ai_addrlen) != 0) {
        error = errno;
        if (error == EINPROGRESS) {
            socklen_t size = sizeof error;
            if (!WaitFor(fd, POLLOUT))
                error = ETIMEDOUT;
            else
                getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size);
        }
    }
    if (error == 0) return fd;
    close(fd);
    errno = error;
    return -1;
}

OrError<int> ConnectTo(const std::string &text) {
    const std::optional<Address> address = ParseAddress(text);
    if (!address)
        return {{}, fmt::format("--display-server: expected host:port, found {}", Shortened(text))};
    addrinfo hints{}, *list = nullptr;
    hints.ai_socktype = SOCK_STREAM;
    if (const int error = getaddrinfo(address->host.c_str(), address->port.c_str(), &hints, &list))
        return {{}, fmt::format("--display-server {}: {}", text, gai_strerror(error))};
    int fd = -1, error = 0;
    for (const addrinfo *a = list; a && fd < 0; a = a->ai_next) {
        fd = ConnectTo(*a);
        error = errno;
    }
    freeaddrinfo(list);
    if (fd < 0)
        return {{},
                fmt::format("--display-server {}: {}; the viewer (tev) must run first", text,
                            std::strerror(error))};
    return {fd, {}};
}

}  // namespace

OrError<std::unique_ptr<DisplayServer>> DisplayServer::Connect(const std::string &address,
                                                               const std::string &name,
                                                               const Film &film,
                                                               const RenderState &state) {
    const OrError<int> socket = ConnectTo(address);
    if (!socket) return {{}, socket.error};
    return {std::unique_ptr<DisplayServer>(
                new DisplayServer(*socket.value, address, name, film, state)),
            {}};
}

DisplayServer::DisplayServer(int socket, std::string address, std::string name, const Film &film,
                             const RenderState &state)
    : socket(socket),
      address(std::move(address)),
      name(std::move(name)),
      film(film),
      state(state),
      sent(state.Tiles().size(), state.Samples().first) {
    try {
        thread = std::thread([this] { Run(); });
    } catch (const std::system_error &e) {
        Warn(fmt::format("--display-server: {}", e.code().message()));
    }
}

DisplayServer::~DisplayServer() {
    {
        const std::lock_guard lock(mutex);
        ended = true;
    }
    wake.notify_all();
    if (thread.joinable()) thread.join();
}

void DisplayServer::Run() {
    const PixelBounds &b = film.Bounds();
    bool listens = SendAll(tev::CreateImage(name, {b.Width(), b.Height()}, kChannels));
    for (bool last = false; listens && !last;) {
        {
            std::unique_lock lock(mutex);
            last = wake.wait_for(lock, kBetweenUpdates, [this] { return ended; });
        }
        listens = SendNews();
    }
    if (!listens)
        Warn(fmt::format("--display-server {}: it takes nothing any more; rendering goes on",
                         address));
}

bool DisplayServer::SendAll(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = send(socket.fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (n >= 0)
            bytes.remove_prefix(size_t(n));
        else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            if (!WaitFor(socket.fd, POLLOUT)) return false;
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

bool DisplayServer::SendNews() {
    Image image = film.NewImage();
    for (size_t tile = 0; tile < sent.size(); ++tile) {
        bool news = false;
        state.Look([&](const TileSums &sums, const std::vector<RenderState::Tile> &tiles) {
            news = tiles[tile].next != sent[tile];
            if (!news) return;
            sent[tile] = tiles[tile].next;
            sums.Develop(tile, &image);
        });
        if (news && !SendTile(tile, image)) return false;
    }
    return true;
}

bool DisplayServer::SendTile(size_t tile, const Image &image) {
    const PixelBounds &t = state.Tiles()[tile], &b = film.Bounds();
    const Point2i from{std::max(t.x0, b.x0) - b.x0, std::max(t.y0, b.y0) - b.y0};
    const Point2i to{std::min(t.x1, b.x1) - b.x0, std::min(t.y1, b.y1) - b.y0};
    std::string packets;
    for (int c = 0; c < int(kChannels.size()); ++c) {
        std::vector<float> values;
        for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x)
                values.push_back(image.Get({x, y}, c));
        packets += tev::UpdateImage(name, kChannels[size_t(c)], from,
                                    {to.x - from.x, to.y - from.y}, values);
    }
    return SendAll(packets);
}

}  // namespace pbrt::program
