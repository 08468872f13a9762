#pragma once

#include <string>
#include <vector>

#include "pbrt/ptex/native/layout.h"
#include "pbrt/ptex/texels.h"

namespace pbrt {

template <typename T>
void AppendBytes(std::string *bytes, const T &value) {
    bytes->append(reinterpret_cast<const char *>(&value), sizeof value);
}

/// zlib's form of some bytes.
std::string Zip(const void *data, size_t size);
template <typename T>
std::string Zip(const std::vector<T> &data) {
    return Zip(data.data(), data.size() * sizeof(T));
}

/// One level as a file holds it.
struct PtexLevel {
    std::vector<PtexBlockHeader> headers;
    std::string blocks;
};

/// The levels of a file: 0 with every face, then, if asked for, the reductions that PtexRank says.
std::vector<PtexLevel> EncodeLevels(const PtexTexels &texels, bool reductions);

}  // namespace pbrt
