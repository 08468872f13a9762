// The writer of Ptex files, by hand because no package of Debian 12 carries a library for them.

#include <fmt/format.h>
#include <half.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pbrt/ptex/ptex_check.h"
#include "pbrt/ptex/ptex_file.h"
#include "pbrt/ptex/reduce.h"
#include "pbrt/util/atomic_file.h"

namespace pbrt {
namespace {

/// Blocks of more bytes are written as tiles of at most this.
constexpr size_t kLargestBlock = 65536;

template <typename T>
void Append(std::string *bytes, const T &value) {
    bytes->append(reinterpret_cast<const char *>(&value), sizeof value);
}

std::string Zip(const void *data, size_t size) {
    uLongf zipped = compressBound(uLong(size));
    std::string out(zipped, '\0');
    compress(reinterpret_cast<Bytef *>(out.data()), &zipped, static_cast<const Bytef *>(data),
             uLong(size));
    out.resize(zipped);
    return out;
}
template <typename T>
std::string Zip(const std::vector<T> &data) {
    return Zip(data.data(), data.size() * sizeof(T));
}

template <typename T>
T Quantized(float v) {
    constexpr float kOne = std::numeric_limits<T>::max();
    return T(std::lround(std::clamp(v, 0.f, 1.f) * kOne));
}
template <>
Imath::half Quantized(float v) {
    return Imath::half(std::clamp(v, -65504.f, 65504.f));
}
template <>
float Quantized(float v) {
    return v;
}

/// A rectangle of texels inside a face of width `stride`.
struct Window {
    size_t stride, x, y, width, height;
};

struct Block {
    PtexBlockHeader header;
    std::string bytes;
};

/// Encodes texels of one stored type.
template <typename T>
class BlockEncoder {
  public:
    explicit BlockEncoder(int nChannels) : nChannels(size_t(nChannels)) {}

    /// One value per channel.
    std::string Pixel(const float *texel) const {
        std::string bytes;
        for (size_t c = 0; c < nChannels; ++c)
            Append(&bytes, Quantized<T>(texel[c]));
        return bytes;
    }
    bool IsConstant(const float *texels, const Window &w) const {
        const float *first = texels + (w.y * w.stride + w.x) * nChannels;
        for (size_t y = 0; y < w.height; ++y)
            for (size_t i = 0; i < w.width * nChannels; ++i)
                if (Quantized<T>(first[y * w.stride * nChannels + i]) !=
                    Quantized<T>(first[i % nChannels]))
                    return false;
        return true;
    }
    /// Whole faces; the sizes are in texels.
    Block Face(const float *texels, int log2U, int log2V) const {
        const size_t pixel = nChannels * sizeof(T), width = size_t(1) << log2U;
        int tileU = log2U, tileV = log2V;
        while ((pixel << (tileU + tileV)) > kLargestBlock && tileU + tileV > 0)
            --(tileU > tileV ? tileU : tileV);
        if (tileU == log2U && tileV == log2V)
            return Zipped(texels, {width, 0, 0, width, size_t(1) << log2V});
        return Tiles(texels, width, size_t(1) << log2V, tileU, tileV);
    }

  private:
    /// Planes of channels; whole numbers as differences that run on through all of them.
    Block Zipped(const float *texels, const Window &w) const {
        std::vector<T> values;
        values.reserve(w.width * w.height * nChannels);
        for (size_t c = 0; c < nChannels; ++c)
            for (size_t y = 0; y < w.height; ++y)
                for (size_t x = 0; x < w.width; ++x)
                    values.push_back(
                        Quantized<T>(texels[((w.y + y) * w.stride + w.x + x) * nChannels + c]));
        if constexpr (std::is_integral_v<T>)
            std::adjacent_difference(values.begin(), values.end(), values.begin(),
                                     [](T a, T b) { return T(a - b); });
        std::string bytes = Zip(values);
        const auto encoding =
            std::is_integral_v<T> ? PtexBlockHeader::DiffZipped : PtexBlockHeader::Zipped;
        const auto size = uint32_t(bytes.size());
        return {PtexBlockHeader(size, encoding), std::move(bytes)};
    }
    Block Tiles(const float *texels, size_t width, size_t height, int tileU, int tileV) const {
        std::vector<PtexBlockHeader> headers;
        std::string tiles;
        const size_t dx = size_t(1) << tileU, dy = size_t(1) << tileV;
        for (size_t y = 0; y < height; y += dy)
            for (size_t x = 0; x < width; x += dx) {
                const Window w{width, x, y, dx, dy};
                Block tile;
                if (IsConstant(texels, w)) {
                    tile.bytes = Pixel(texels + (y * width + x) * nChannels);
                    tile.header = {uint32_t(tile.bytes.size()), PtexBlockHeader::Constant};
                } else {
                    tile = Zipped(texels, w);
                }
                headers.push_back(tile.header);
                tiles += tile.bytes;
            }
        const std::string zippedHeaders = Zip(headers);
        Block block;
        Append(&block.bytes, int8_t(tileU));
        Append(&block.bytes, int8_t(tileV));
        Append(&block.bytes, uint32_t(zippedHeaders.size()));
        block.bytes += zippedHeaders;
        block.bytes += tiles;
        block.header = {uint32_t(block.bytes.size()), PtexBlockHeader::Tiled};
        return block;
    }

    size_t nChannels;
};

struct Level {
    std::vector<PtexBlockHeader> headers;
    std::string blocks;
    void Add(const Block &block) {
        headers.push_back(block.header);
        blocks += block.bytes;
    }
};

/// All parts of a file that hold texels.
struct Encoded {
    std::vector<PtexFaceInfo> faces;
    std::string constants;  ///< a pixel a face: its mean
    std::vector<Level> levels;
};

std::vector<float> Mean(const float *texels, size_t nTexels, size_t nChannels) {
    std::vector<double> sum(nChannels);
    for (size_t i = 0; i < nTexels * nChannels; ++i)
        sum[i % nChannels] += texels[i];
    std::vector<float> mean;
    for (double s : sum)
        mean.push_back(float(s / double(nTexels)));
    return mean;
}

PtexFaceInfo InfoOf(const PtexFace &face, bool constant) {
    PtexFaceInfo info{int8_t(face.log2U), int8_t(face.log2V), 0, 0, {}};
    if (constant) info.flags = PtexFaceInfo::kConstant;
    for (int e = 0; e < 4; ++e) {
        info.neighbours[e] = face.neighbours[size_t(e)];
        info.neighbourEdges |= uint8_t(face.neighbourEdges[size_t(e)] << 2 * e);
    }
    return info;
}

/// Marks constant faces whose neighbours are constant and of the same color.
void MarkNeighboursConstant(Encoded *e, size_t pixel) {
    const auto colour = [&](int f) {
        return std::string_view(e->constants).substr(size_t(f) * pixel, pixel);
    };
    for (size_t f = 0; f < e->faces.size(); ++f) {
        PtexFaceInfo &info = e->faces[f];
        if (!(info.flags & PtexFaceInfo::kConstant)) continue;
        const bool same = std::all_of(info.neighbours, info.neighbours + 4, [&](int n) {
            return n < 0 || ((e->faces[size_t(n)].flags & PtexFaceInfo::kConstant) &&
                             colour(n) == colour(int(f)));
        });
        if (same) info.flags |= PtexFaceInfo::kNeighboursConstant;
    }
}

template <typename T>
void AddReductions(const PtexContent &content, const std::vector<size_t> &begins, Encoded *e) {
    const BlockEncoder<T> encoder(content.nChannels);
    std::vector<size_t> order(content.faces.size());
    std::iota(order.begin(), order.end(), size_t(0));
    const auto rank = [&](size_t f) {
        return PtexRank(content.faces[f].log2U, content.faces[f].log2V,
                        e->faces[f].flags & PtexFaceInfo::kConstant);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return rank(a) > rank(b); });
    for (size_t f : order) {
        if (rank(f) <= kPtexLeastLog2) break;
        const PtexFace &face = content.faces[f];
        const float *texels = content.texels.data() + begins[f];
        std::vector<float> reduced;
        for (int level = 1; rank(f) - level >= kPtexLeastLog2; ++level) {
            reduced = HalfSize(content.mesh, texels, face.log2U - level + 1, face.log2V - level + 1,
                               content.nChannels);
            texels = reduced.data();
            if (size_t(level) == e->levels.size()) e->levels.emplace_back();
            e->levels[size_t(level)].Add(
                encoder.Face(texels, face.log2U - level, face.log2V - level));
        }
    }
}

template <typename T>
Encoded Encode(const PtexContent &content) {
    const BlockEncoder<T> encoder(content.nChannels);
    const size_t nChannels = size_t(content.nChannels);
    Encoded e;
    e.levels.resize(1);
    std::vector<size_t> begins;
    size_t begin = 0;
    for (const PtexFace &face : content.faces) {
        const float *texels = content.texels.data() + begin;
        const size_t n = face.NTexels();
        const bool constant = encoder.IsConstant(texels, {n, 0, 0, n, 1});
        e.faces.push_back(InfoOf(face, constant));
        e.constants += encoder.Pixel(constant ? texels : Mean(texels, n, nChannels).data());
        e.levels[0].Add(constant ? Block() : encoder.Face(texels, face.log2U, face.log2V));
        begins.push_back(begin);
        begin += n * nChannels;
    }
    MarkNeighboursConstant(&e, nChannels * sizeof(T));
    AddReductions<T>(content, begins, &e);
    return e;
}

Encoded EncodeAs(const PtexContent &content) {
    switch (content.type) {
        case PtexType::UInt8:
            return Encode<uint8_t>(content);
        case PtexType::UInt16:
            return Encode<uint16_t>(content);
        case PtexType::Half:
            return Encode<Imath::half>(content);
        default:
            return Encode<float>(content);
    }
}

std::string Metadata(const PtexContent &content) {
    std::string bytes;
    for (const auto &[key, value] : content.metadata) {
        Append(&bytes, uint8_t(key.size() + 1));
        bytes.append(key.c_str(), key.size() + 1);
        Append(&bytes, uint8_t(0));  // a string
        Append(&bytes, uint32_t(value.size() + 1));
        bytes.append(value.c_str(), value.size() + 1);
    }
    return bytes;
}

std::string FileBytes(const PtexContent &content) {
    const Encoded e = EncodeAs(content);
    const std::string faceInfo = Zip(e.faces),
                      constants = Zip(e.constants.data(), e.constants.size());
    std::string levelInfo, levelData;
    for (const Level &level : e.levels) {
        const std::string headers = Zip(level.headers);
        Append(&levelInfo, PtexLevelInfo{headers.size() + level.blocks.size(),
                                         uint32_t(headers.size()), uint32_t(level.headers.size())});
        levelData += headers;
        levelData += level.blocks;
    }
    const std::string metadata = Metadata(content);
    const std::string zippedMetadata =
        metadata.empty() ? std::string() : Zip(metadata.data(), metadata.size());

    PtexHeader header;
    header.mesh = uint32_t(content.mesh);
    header.type = uint32_t(content.type);
    header.alphaChannel = content.alphaChannel;
    header.nChannels = uint16_t(content.nChannels);
    header.nLevels = uint16_t(e.levels.size());
    header.nFaces = uint32_t(content.faces.size());
    header.extHeaderSize = sizeof(PtexExtHeader);
    header.faceInfoSize = uint32_t(faceInfo.size());
    header.constantSize = uint32_t(constants.size());
    header.levelInfoSize = uint32_t(levelInfo.size());
    header.levelDataSize = levelData.size();
    header.metadataZipSize = uint32_t(zippedMetadata.size());
    header.metadataSize = uint32_t(metadata.size());
    PtexExtHeader ext;
    ext.editPosition = sizeof header + sizeof ext + faceInfo.size() + constants.size() +
                       levelInfo.size() + levelData.size() + zippedMetadata.size();
    std::string bytes;
    Append(&bytes, header);
    Append(&bytes, ext);
    return bytes + faceInfo + constants + levelInfo + levelData + zippedMetadata;
}

}  // namespace

std::optional<std::string> WritePtex(const std::string &fileName, const PtexContent &content) {
    if (const std::string wrong = WhatIsWrong(content); !wrong.empty())
        return fmt::format("{}: cannot be written: {}", fileName, wrong);
    return WriteFileAtomically(fileName, FileBytes(content));
}

}  // namespace pbrt
