#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pbrt/util/unpacked.h"

namespace pbrt {

/// A file, gzipped or not, read forwards through a window.
class PlyStream {
  public:
    explicit PlyStream(const std::string &fileName);
    ~PlyStream();
    PlyStream(const PlyStream &) = delete;
    PlyStream &operator=(const PlyStream &) = delete;

    /// Largest n that Fill takes.
    static constexpr size_t kMostAhead = size_t(1) << 16;

    /// Reads ahead. True where n <= kMostAhead more bytes are there; they are at Data() then.
    bool Fill(size_t n) { return Available() >= n || Refill(n); }
    const uint8_t *Data() const { return at; }
    /// Bytes at Data(), perhaps more than were asked for.
    size_t Available() const { return size_t(end - at); }
    void Skip(size_t n) { at += n; }

    /// Why the file cannot be read, or empty; the end of the file is no problem.
    const std::string &Problem() const { return problem; }
    /// True where the bytes that are left are known (no gzip).
    bool KnowsLength() const { return knowsLength; }
    /// Bytes that are left, or the most that a gzipped file may yet unpack to.
    uint64_t BytesLeft() const {
        return (knowsLength ? fileSize : MostUnpacked(fileSize)) - (read - Available());
    }

  private:
    bool Refill(size_t n);
    gzFile file = nullptr;
    std::vector<uint8_t> window;
    const uint8_t *at, *end;
    uint64_t fileSize = 0, read = 0;
    bool knowsLength = false;
    std::string problem;
};

}  // namespace pbrt
