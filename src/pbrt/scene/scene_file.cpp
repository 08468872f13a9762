#include "pbrt/scene/scene_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <new>

#include "pbrt/util/memory.h"
#include "pbrt/util/unpacked.h"

namespace pbrt {
namespace {

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

/// Room for what is unpacked next; false and `why` where there should be no more.
bool MakeRoom(std::string &out, size_t packed, std::string &why) {
    constexpr size_t kChunk = 1 << 20, kWorthAsking = 16 * kChunk;
    const size_t before = out.size(), after = before + std::max(kChunk, before / 2);
    if (auto tooLarge = WhyUnpackedTooLarge(before, packed))
        return why = fmt::format("it {}", *tooLarge), false;
    // A string that grows may take twice its size while its old bytes are still there.
    if (after > out.capacity() && after > kWorthAsking)
        if (auto tooLarge = WhyTooLarge(2 * out.capacity()))
            return why = fmt::format("it {}", *tooLarge), false;
    out.resize(after);
    return true;
}

/// Inflates what is left of one member, appending to `out`; the zlib status at its end, Z_MEM_ERROR
/// and `why` where it is too large.
int InflateMember(z_stream &z, std::string_view &in, size_t packed, std::string &out,
                  std::string &why) {
    int status = Z_OK;
    while (status == Z_OK) {
        const size_t before = out.size(), given = std::min<size_t>(in.size(), 1u << 30);
        if (!MakeRoom(out, packed, why)) return Z_MEM_ERROR;
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
    const size_t packed = in.size();
    std::string out;
    bool first = true;
    while (first || in.find_first_not_of('\0') != in.npos) {  // zeros may pad the file's end
        if (!first) inflateReset(&inflater.stream);
        const int status = InflateMember(inflater.stream, in, packed, out, why);
        if (status == Z_MEM_ERROR && !why.empty()) return {};
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

std::optional<std::string> ReadFileContents(const std::string &path, Pipes pipes,
                                            const FileLoc &use, Diagnostics &log) {
    FileContents file = path == "-" ? ReadStandardInput() : ReadWholeFile(path, pipes);
    if (file.bytes && EndsInGz(path)) {
        try {
            file.bytes = Gunzip(*file.bytes, file.reason);
        } catch (const std::bad_alloc &) {
            file.bytes.reset();
            file.reason = "there is not enough memory for it";
        }
    }
    if (!file.bytes) log.Error(use, fmt::format("cannot read \"{}\": {}", path, file.reason));
    return std::move(file.bytes);
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
