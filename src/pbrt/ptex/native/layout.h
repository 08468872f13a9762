#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "pbrt/ptex/texels.h"

namespace pbrt {

// The layout of a Ptex file, version 1.4: little endian, packed.

static_assert(std::endian::native == std::endian::little, "Ptex files are little endian");

struct PtexHeader {
    char magic[4] = {'P', 't', 'e', 'x'};
    uint32_t version = 1;
    uint32_t mesh, type;
    int32_t alphaChannel;
    uint16_t nChannels, nLevels;
    uint32_t nFaces;
    uint32_t extHeaderSize, faceInfoSize, constantSize, levelInfoSize;
    uint32_t minorVersion = 4;
    uint64_t levelDataSize;
    uint32_t metadataZipSize, metadataSize;
};
static_assert(sizeof(PtexHeader) == 64);

struct PtexExtHeader {
    uint16_t uBorder = 0, pad0 = 0, vBorder = 0, edgeFilter = 0;
    uint32_t largeMetadataHeaderZipSize = 0, largeMetadataHeaderSize = 0;
    uint64_t largeMetadataSize = 0, editSize = 0, editPosition = 0;
};
static_assert(sizeof(PtexExtHeader) == 40);

struct PtexFaceInfo {
    static constexpr uint8_t kConstant = 1, kHasEdits = 2, kNeighboursConstant = 4, kSubface = 8;
    int8_t log2U, log2V;
    uint8_t neighbourEdges;  ///< 2 bits each, edge 0 lowest
    uint8_t flags;
    int32_t neighbours[4];
};
static_assert(sizeof(PtexFaceInfo) == 20);

struct PtexLevelInfo {
    uint64_t dataSize;
    uint32_t headerSize, nFaces;
};
static_assert(sizeof(PtexLevelInfo) == 16);

/// Size and encoding of a face's or a tile's block, as one word.
struct PtexBlockHeader {
    static constexpr uint32_t kSizeBits = 30;
    enum Encoding : uint32_t { Constant, Zipped, DiffZipped, Tiled };
    uint32_t word = 0;
    PtexBlockHeader() = default;
    PtexBlockHeader(uint32_t size, Encoding encoding) : word(size | encoding << kSizeBits) {}
    uint32_t Size() const { return word & ((1u << kSizeBits) - 1); }
    Encoding BlockEncoding() const { return Encoding(word >> kSizeBits); }
};
static_assert(sizeof(PtexBlockHeader) == 4);

/// Bytes that precede the tiles of a tiled face.
constexpr size_t kPtexTileHeaderSize = 6;  ///< i8 log2 tile u, i8 log2 tile v, u32 zipped size

/// Level l > 0 holds the faces of rank at least l + kPtexLeastLog2. Rank: log2 of the shorter
/// side's texels, 1 where the face is constant.
constexpr int kPtexLeastLog2 = 2;
inline int PtexRank(int log2U, int log2V, bool constant) {
    return constant ? 1 : std::min(log2U, log2V);
}

/// The faces as all levels above 0 list them: by falling rank, equal ones by number.
std::vector<int> PtexReductionOrder(const PtexTexels &texels);

}  // namespace pbrt
