#include "pbrt/scene/scene_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

namespace pbrt {
namespace {

struct CloseFile {
    void operator()(std::FILE *f) const {
        if (f != stdin) std::fclose(f);
    }
};

/// The rest of an open file; empty optional and errno where reading fails.
std::optional<std::string> ReadAll(std::FILE *f, size_t expectedSize) {
    std::string bytes;
    size_t size = 0;
    bytes.resize(expectedSize + 1);  // one more, so that a last read can see the end
    for (;;) {
        size += std::fread(bytes.data() + size, 1, bytes.size() - size, f);
        if (std::ferror(f)) return {};
        if (size < bytes.size()) break;
        bytes.resize(2 * size + 4096);
    }
    bytes.resize(size);
    return bytes;
}

bool EndsInGz(std::string_view name) {
    if (name.size() < 3) return false;
    const std::string_view tail = name.substr(name.size() - 3);
    return tail[0] == '.' && (tail[1] | 32) == 'g' && (tail[2] | 32) == 'z';
}

/// Ends inflation whatever happens.
struct Inflater {
    z_stream stream{};
    bool ready = inflateInit2(&stream, 16 + MAX_WBITS) == Z_OK;  // 16: gzip headers
    ~Inflater() { inflateEnd(&stream); }
};

/// Inflates what is left of one member, appending to `out`; the zlib status at its end.
int InflateMember(z_stream &z, std::string_view &in, std::string &out) {
    constexpr size_t kChunk = 1 << 20;
    int status = Z_OK;
    while (status == Z_OK) {
        const size_t before = out.size(), given = std::min<size_t>(in.size(), 1u << 30);
        out.resize(before + std::max(kChunk, before / 2));
        z.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(in.data()));
        z.avail_in = uInt(given);
        const size_t room = std::min<size_t>(out.size() - before, 1u << 30);
        z.next_out = reinterpret_cast<Bytef *>(out.data() + before);
        z.avail_out = uInt(room);
        status = inflate(&z, Z_NO_FLUSH);
        in.remove_prefix(given - z.avail_in);
        out.resize(before + room - z.avail_out);
    }
    return status;
}

}  // namespace

std::optional<std::string> Gunzip(std::string_view in, std::string &why) {
    Inflater inflater;
    if (!inflater.ready) return why = "zlib cannot start", std::nullopt;
    std::string out;
    bool first = true;
    while (first || in.find_first_not_of('\0') != in.npos) {  // zeros may pad the file's end
        if (!first) inflateReset(&inflater.stream);
        const int status = InflateMember(inflater.stream, in, out);
        if (status == Z_BUF_ERROR) return why = "the compressed data is cut short", std::nullopt;
        if (status != Z_STREAM_END) {
            const char *message = inflater.stream.msg;
            why = fmt::format("the compressed data is damaged ({})",
                              message ? message : zError(status));
            return {};
        }
        first = false;
    }
    return out;
}

std::optional<std::string> ReadFileContents(const std::string &path, const FileLoc &use,
                                            Diagnostics &log) {
    std::string why;
    std::optional<std::string> bytes;
    try {
        const std::unique_ptr<std::FILE, CloseFile> file(
            path == "-" ? stdin : std::fopen(path.c_str(), "rb"));
        if (file) {
            std::error_code unknownSize;
            const auto size = std::filesystem::file_size(path, unknownSize);
            bytes = ReadAll(file.get(), unknownSize ? 4096 : size_t(size));
        }
        if (!bytes)
            why = std::strerror(errno);
        else if (EndsInGz(path))
            bytes = Gunzip(*bytes, why);
    } catch (const std::bad_alloc &) {
        bytes.reset();
        why = "there is not enough memory for it";
    }
    if (!bytes) log.Error(use, fmt::format("cannot read \"{}\": {}", path, why));
    return bytes;
}

std::string ResolvePath(std::string_view name, std::string_view dir) {
    if (dir.empty() || name.starts_with('/')) return std::string(name);
    std::string inside = fmt::format("{}/{}", dir, name);
    std::error_code ignored;
    return std::filesystem::exists(inside, ignored) ? inside : std::string(name);
}

std::string FolderOf(std::string_view path) {
    const size_t slash = path.rfind('/');
    if (slash == path.npos) return "";
    return std::string(slash == 0 ? "/" : path.substr(0, slash));
}

}  // namespace pbrt
