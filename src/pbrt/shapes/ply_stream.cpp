#include "pbrt/shapes/ply_stream.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "pbrt/util/read_file.h"

namespace pbrt {

namespace {
constexpr size_t kWindow = size_t(1) << 18;
}

PlyStream::PlyStream(const std::string &fileName) : window(kWindow) {
    at = end = window.data();
    if (const auto why = WhyNoFile(fileName)) {
        problem = "cannot be opened: " + *why;
        return;
    }
    file = gzopen(fileName.c_str(), "rb");
    if (!file) {
        problem = errno ? std::string("cannot be opened: ") + std::strerror(errno)
                        : "cannot be opened: not enough memory";
        return;
    }
    gzbuffer(file, unsigned(kWindow / 4));
    std::error_code error;
    fileSize = std::filesystem::file_size(fileName, error);
    knowsLength = !error && gzdirect(file);
}

PlyStream::~PlyStream() {
    if (file) gzclose(file);
}

bool PlyStream::Refill(size_t n) {
    if (!file) return false;
    const size_t kept = Available();
    std::memmove(window.data(), at, kept);
    at = window.data();
    end = at + kept;
    while (Available() < n) {
        const size_t have = Available();
        const int got = gzread(file, window.data() + have, unsigned(kWindow - have));
        if (got <= 0) {
            int code = Z_OK;
            const char *const text = gzerror(file, &code);
            if (code == Z_BUF_ERROR)
                problem = "its gzip data end early";
            else if (code == Z_ERRNO)
                problem = std::string("cannot be read: ") + std::strerror(errno);
            else if (code != Z_OK && code != Z_STREAM_END)
                problem = std::string("its gzip data are damaged: ") + text;
            return false;
        }
        end += got;
        read += size_t(got);
        if (const auto why = knowsLength ? std::nullopt : WhyUnpackedTooLarge(read, fileSize)) {
            problem = *why;
            return false;
        }
    }
    return true;
}

}  // namespace pbrt
