#include "pbrt/util/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace pbrt {
namespace {

std::string Sentence(const std::string &fileName, std::string_view what, int error) {
    return fmt::format("{}: {}: {}", fileName, what, std::strerror(error));
}

/// A file descriptor that closes itself.
struct Descriptor {
    int fd = -1;
    explicit Descriptor(int fd) : fd(fd) {}
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;
    ~Descriptor() {
        if (fd >= 0) close(fd);
    }
};

bool WriteAll(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = write(fd, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return false;
        bytes.remove_prefix(size_t(n));
    }
    return true;
}

/// Where the bytes belong: the end of a chain of symbolic links.
struct Target {
    std::string path;
    bool inPlace = false;        ///< a device or a pipe: nothing to rename
    std::optional<mode_t> mode;  ///< of the file that is replaced
};

Target Resolve(const std::string &fileName) {
    Target target{fileName, false, {}};
    std::error_code unresolved;  // a link that leads nowhere is replaced itself
    const std::filesystem::path real = std::filesystem::canonical(fileName, unresolved);
    if (!unresolved) target.path = real.string();
    struct stat status {};
    if (stat(target.path.c_str(), &status) != 0) return target;
    target.inPlace = !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    if (S_ISREG(status.st_mode)) target.mode = status.st_mode & 07777;
    return target;
}

/// Creates a file in the target's folder under a name that nobody else uses.
int OpenTemporary(std::string *name, const std::string &path) {
    int fd = -1;
    for (int i = 0; fd < 0 && (i == 0 || errno == EEXIST); ++i) {
        *name = fmt::format("{}.{}-{}.tmp", path, getpid(), i);
        fd = open(name->c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    return fd;
}

std::optional<std::string> WriteInPlace(const std::string &fileName, std::string_view contents) {
    const Descriptor file(open(fileName.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.fd < 0) return Sentence(fileName, "cannot be opened for writing", errno);
    if (!WriteAll(file.fd, contents)) return Sentence(fileName, "cannot be written", errno);
    return {};
}

}  // namespace

std::optional<std::string> WriteFileAtomically(const std::string &fileName,
                                               std::string_view contents) {
    const Target target = Resolve(fileName);
    if (target.inPlace) return WriteInPlace(target.path, contents);
    std::string temporary;
    int error = 0;
    {
        const Descriptor file(OpenTemporary(&temporary, target.path));
        if (file.fd < 0) return Sentence(fileName, "cannot be created", errno);
        if (target.mode && fchmod(file.fd, *target.mode) != 0) error = errno;
        if (error == 0 && !WriteAll(file.fd, contents)) error = errno;
        // Full disks and quotas may show only here.
        if (error == 0 && fsync(file.fd) != 0) error = errno;
    }
    if (error == 0 && rename(temporary.c_str(), target.path.c_str()) != 0) error = errno;
    if (error == 0) return {};
    unlink(temporary.c_str());
    return Sentence(fileName, "cannot be written", error);
}

std::optional<std::string> WhyNotWritable(const std::string &fileName) {
    const Target target = Resolve(fileName);
    if (target.inPlace) {
        if (access(target.path.c_str(), W_OK) == 0) return {};
        return Sentence(fileName, "cannot be opened for writing", errno);
    }
    std::error_code unknown;
    if (std::filesystem::is_directory(target.path, unknown))
        return Sentence(fileName, "cannot be written", EISDIR);
    std::string temporary;
    const Descriptor file(OpenTemporary(&temporary, target.path));
    if (file.fd < 0) return Sentence(fileName, "cannot be created", errno);
    unlink(temporary.c_str());
    return {};
}

FileContents ReadWholeFile(const std::string &fileName) {
    const Descriptor file(open(fileName.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.fd < 0) return {{}, Sentence(fileName, "cannot be opened", errno)};
    std::string bytes;
    struct stat status {};
    if (fstat(file.fd, &status) == 0 && S_ISREG(status.st_mode)) bytes.reserve(status.st_size);
    char buffer[1 << 16];
    for (;;) {
        const ssize_t n = read(file.fd, buffer, sizeof buffer);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return {{}, Sentence(fileName, "cannot be read", errno)};
        if (n == 0) return {std::move(bytes), {}};
        bytes.append(buffer, size_t(n));
    }
}

}  // namespace pbrt
