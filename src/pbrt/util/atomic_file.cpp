#include "pbrt/util/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "pbrt/util/descriptor.h"
#include "pbrt/util/write_all.h"

namespace pbrt {
namespace {

namespace fs = std::filesystem;

std::string Sentence(const std::string &fileName, std::string_view what, int error) {
    return fmt::format("{}: {}: {}", fileName, what, std::strerror(error));
}

/// The path that the bytes belong to.
struct Target {
    fs::path path;               ///< the end of a chain of symbolic links
    std::string folder;          ///< of `path`
    bool inPlace = false;        ///< a device or a pipe: nothing to rename
    std::optional<mode_t> mode;  ///< of the file that is replaced
    int error = 0;               ///< why it cannot be written, as errno tells
};

/// The end of a chain of symbolic links, which need not exist.
fs::path EndOfLinks(fs::path path) {
    constexpr int kMostLinks = 40;  // as Linux
    std::error_code notALink;
    for (int i = 0; i < kMostLinks; ++i) {
        const fs::path next = fs::read_symlink(path, notALink);
        if (notALink) break;
        path = path.parent_path() / next;
    }
    return path;
}

Target Resolve(const std::string &fileName) {
    Target target;
    target.path = fileName;
    struct stat status {};
    const bool exists = stat(fileName.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) target.error = errno;
    if (exists && S_ISDIR(status.st_mode)) target.error = EISDIR;
    target.inPlace = exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    if (exists && S_ISREG(status.st_mode)) {
        target.mode = status.st_mode & 07777;
        // The superuser may write everything; the mode says that nobody should.
        if (!(status.st_mode & 0222)) target.error = EACCES;
    }
    if (exists && target.error == 0 && faccessat(AT_FDCWD, fileName.c_str(), W_OK, AT_EACCESS) != 0)
        target.error = errno;
    if (!target.inPlace) target.path = EndOfLinks(target.path);
    target.folder = target.path.has_parent_path() ? target.path.parent_path().string() : ".";
    return target;
}

/// A new file in the folder without a name; -1 where the file system has none of these.
int OpenUnnamed(const std::string &folder) {
    return open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

/// Calls take(name) with names of the folder until it finds one that nobody has; 0 or errno.
template <typename Take>
int WithNewName(const std::string &folder, std::string *name, Take take) {
    for (int i = 0;; ++i) {
        *name = fmt::format("{}/pbrt-{}-{}.tmp", folder, getpid(), i);
        if (take(name->c_str())) return 0;
        if (errno != EEXIST) return errno;
    }
}

int OpenNamed(const std::string &folder, std::string *name) {
    int fd = -1;
    WithNewName(folder, name, [&](const char *n) {
        fd = open(n, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        return fd >= 0;
    });
    return fd;
}

/// Gives the file its rights and bytes; 0 or errno.
int Fill(int fd, const Target &target, std::string_view contents) {
    if (target.mode && fchmod(fd, *target.mode) != 0) return errno;
    if (const int error = WriteAll(fd, contents, BrokenPipe::Fails)) return error;
    // Full disks and quotas may show only here.
    return fsync(fd) == 0 ? 0 : errno;
}

/// The new name is on the disk after this, too; where it is not, the old file is.
void FlushFolder(const std::string &folder) {
    const Descriptor self(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (self.fd >= 0) fsync(self.fd);
}

/// Renames the temporary file, or removes it where something went wrong; 0 or errno.
int Rename(const std::string &temporary, const Target &target, int error) {
    if (error == 0 && rename(temporary.c_str(), target.path.c_str()) != 0) error = errno;
    if (error != 0) unlink(temporary.c_str());
    return error;
}

/// nullopt where the file can get no name, for want of /proc or of hard links; else 0 or errno.
std::optional<int> NameIt(int fd, const Target &target) {
    const std::string self = fmt::format("/proc/self/fd/{}", fd);
    const auto link = [&](const char *name) {
        return linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
    };
    if (!target.mode && link(target.path.c_str())) return 0;
    std::string temporary;  // a link cannot replace a file
    if (WithNewName(target.folder, &temporary, link) != 0) return {};
    return Rename(temporary, target, 0);
}

/// 0, errno, or nullopt where this way is barred.
std::optional<int> WriteUnnamed(const Target &target, std::string_view contents) {
    const Descriptor file(OpenUnnamed(target.folder));
    if (file.fd < 0) return {};
    if (const int error = Fill(file.fd, target, contents)) return error;
    return NameIt(file.fd, target);
}

int WriteNamed(const Target &target, std::string_view contents) {
    std::string temporary;
    int error = 0;
    {
        const Descriptor file(OpenNamed(target.folder, &temporary));
        if (file.fd < 0) return errno;
        error = Fill(file.fd, target, contents);
    }
    return Rename(temporary, target, error);
}

std::optional<std::string> WriteInPlace(const std::string &fileName, std::string_view contents) {
    const Descriptor file(open(fileName.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (file.fd < 0) return Sentence(fileName, "cannot be opened for writing", errno);
    const int error = WriteAll(file.fd, contents, BrokenPipe::Fails);
    if (error != 0) return Sentence(fileName, "cannot be written", error);
    return {};
}

/// Why nothing can be created in the target's folder.
std::optional<std::string> WhyNoNewFile(const std::string &fileName, const Target &target) {
    const Descriptor unnamed(OpenUnnamed(target.folder));
    if (unnamed.fd >= 0) return {};
    std::string temporary;
    const Descriptor named(OpenNamed(target.folder, &temporary));
    if (named.fd < 0) return Sentence(fileName, "cannot be created", errno);
    unlink(temporary.c_str());
    return {};
}

}  // namespace

std::optional<std::string> WriteFileAtomically(const std::string &fileName,
                                               std::string_view contents) {
    const Target target = Resolve(fileName);
    if (target.error != 0) return Sentence(fileName, "cannot be written", target.error);
    if (target.inPlace) return WriteInPlace(fileName, contents);
    if (auto why = WhyNoNewFile(fileName, target)) return why;
    std::optional<int> error = WriteUnnamed(target, contents);
    if (!error) error = WriteNamed(target, contents);
    if (*error != 0) return Sentence(fileName, "cannot be written", *error);
    FlushFolder(target.folder);
    return {};
}

std::optional<std::string> WhyNotWritable(const std::string &fileName) {
    const Target target = Resolve(fileName);
    if (target.error != 0) return Sentence(fileName, "cannot be written", target.error);
    return target.inPlace ? std::nullopt : WhyNoNewFile(fileName, target);
}

}  // namespace pbrt
