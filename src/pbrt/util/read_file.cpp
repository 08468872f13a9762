#include "pbrt/util/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include "pbrt/util/descriptor.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

/// Less memory is always there; asking for it would take longer than reading a small file.
constexpr uint64_t kSmall = uint64_t(1) << 24;

FileContents Refused(std::string reason) {
    return {{}, fmt::format("cannot be read: {}", reason), std::move(reason)};
}

FileContents CannotBe(std::string_view done, int error) {
    return {{}, fmt::format("cannot be {}: {}", done, std::strerror(error)), std::strerror(error)};
}

/// Reads to the end. `size`: the expected one, which may be wrong either way.
FileContents ReadToEnd(int fd, uint64_t size, uint64_t most) {
    const auto tooMuch = [&] {
        return Refused(fmt::format("it holds more than {}, the most that is read", ByteText(most)));
    };
    if (size > most) return tooMuch();
    std::string bytes;
    size_t filled = 0;
    for (uint64_t room = size + 1;;) {        // one more shows the end
        const uint64_t both = room + filled;  // while a string grows, its old bytes are there
        const auto why = both > kSmall ? WhyTooLarge(both) : std::nullopt;
        if (why) return Refused(fmt::format("it {}", *why));
        bytes.resize(room);
        while (filled < bytes.size()) {
            const ssize_t n = read(fd, bytes.data() + filled, bytes.size() - filled);
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) return CannotBe("read", errno);
            if (n == 0) {
                bytes.resize(filled);
                return {std::move(bytes), {}, {}};
            }
            filled += size_t(n);
            if (filled > most) return tooMuch();
        }
        room = 2 * room + (uint64_t(1) << 16);
    }
}

FileContents ReadOpen(int fd, uint64_t most) {
    struct stat status {};
    const bool known = fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
    try {
        return ReadToEnd(fd, known ? uint64_t(status.st_size) : 0, most);
    } catch (const std::bad_alloc &) {
        return Refused("there is not enough memory for it");
    }
}

FileContents Read(const std::string &fileName, Pipes pipes, uint64_t most) {
    struct stat status {};
    if (stat(fileName.c_str(), &status) != 0) return CannotBe("opened", errno);
    if (auto why = WhyNoFile(fileName, pipes)) return Refused(*why);
    const Descriptor file(open(fileName.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (file.fd < 0) return CannotBe("opened", errno);
    return ReadOpen(file.fd, most);
}

FileContents Named(FileContents contents, std::string_view name) {
    if (!contents.bytes) contents.error = fmt::format("{}: {}", name, contents.error);
    return contents;
}

}  // namespace

std::optional<std::string> WhyNoFile(const std::string &fileName, Pipes pipes) {
    struct stat status {};
    if (stat(fileName.c_str(), &status) != 0) return std::strerror(errno);
    const mode_t mode = status.st_mode;
    if (S_ISREG(mode) || (S_ISFIFO(mode) && pipes == Pipes::Taken)) return {};
    if (S_ISDIR(mode)) return std::strerror(EISDIR);
    if (S_ISFIFO(mode)) return "it is a pipe; expected a file";
    return "it is a device; expected a file";
}

FileContents ReadWholeFile(const std::string &fileName, Pipes pipes, uint64_t most) {
    return Named(Read(fileName, pipes, most), fileName);
}

FileContents ReadStandardInput() {
    return Named(ReadOpen(STDIN_FILENO, std::numeric_limits<uint64_t>::max()), "standard input");
}

}  // namespace pbrt
