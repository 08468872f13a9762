#include "pbrt/ptex/native/decode.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstring>
#include <numeric>
#include <optional>
#include <type_traits>

namespace pbrt {
namespace {

/// Parts of a tiled block.
struct TileTable {
    int log2U, log2V;  ///< of a tile
    std::vector<PtexBlockHeader> headers;
    std::string_view tiles;

    /// Calls f(block, x, y) for every tile, x and y in tiles, until one gives a reason to stop.
    template <typename F>
    std::string ForEach(int nAlongU, F f) const {
        std::string_view rest = tiles;
        for (size_t i = 0; i < headers.size(); ++i) {
            const uint32_t size = headers[i].Size();
            if (size > rest.size()) return fmt::format("tile {} reaches beyond its face", i);
            const std::string why = f(PtexBlock{headers[i], rest.substr(0, size), log2U, log2V},
                                      i % size_t(nAlongU), i / size_t(nAlongU));
            if (!why.empty()) return fmt::format("tile {}: {}", i, why);
            rest.remove_prefix(size);
        }
        return {};
    }
};

std::optional<TileTable> ReadTileTable(const PtexBlock &face) {
    if (face.bytes.size() < kPtexTileHeaderSize) return {};
    TileTable table{int8_t(face.bytes[0]), int8_t(face.bytes[1]), {}, {}};
    if (table.log2U < 0 || table.log2U > face.log2U || table.log2V < 0 || table.log2V > face.log2V)
        return {};
    uint32_t zipped;
    std::memcpy(&zipped, face.bytes.data() + 2, sizeof zipped);
    const std::string_view rest = face.bytes.substr(kPtexTileHeaderSize);
    const size_t n = size_t(1) << (face.log2U - table.log2U + face.log2V - table.log2V);
    if (zipped > rest.size() || !CanInflate(zipped, n * sizeof(PtexBlockHeader))) return {};
    table.headers.resize(n);
    if (!Inflate(rest.substr(0, zipped), table.headers.data(), n * sizeof(PtexBlockHeader)))
        return {};
    table.tiles = rest.substr(zipped);
    return table;
}

constexpr const char *kBadTiles = "its list of tiles is damaged";

std::string CheckPlain(const PtexBlock &block, const PtexTexels &layout, uint64_t *constantBytes) {
    const size_t pixel = layout.PixelSize(), raw = pixel << (block.log2U + block.log2V);
    switch (block.header.BlockEncoding()) {
        case PtexBlockHeader::Constant:
            *constantBytes += raw;
            if (block.bytes.empty() || block.bytes.size() == pixel) return {};
            return fmt::format("a constant of {} bytes, pixels have {}", block.bytes.size(), pixel);
        case PtexBlockHeader::DiffZipped:
            if (layout.Type() != PtexType::UInt8 && layout.Type() != PtexType::UInt16)
                return "differences of numbers that are not whole";
            [[fallthrough]];
        case PtexBlockHeader::Zipped:
            if (CanInflate(block.bytes.size(), raw)) return {};
            return fmt::format("{} bytes cannot hold {} x {} texels", block.bytes.size(),
                               1 << block.log2U, 1 << block.log2V);
        default:
            return "tiles inside a tile";
    }
}

/// A block that is no tiling, to `width` x `height` texels of a face of `stride` texels.
template <typename T>
std::string DecodePlain(const PtexBlock &block, size_t nChannels, const std::byte *color,
                        size_t stride, T *to) {
    const size_t width = size_t(1) << block.log2U, height = size_t(1) << block.log2V;
    const size_t plane = width * height;
    std::vector<T> values;
    if (block.header.BlockEncoding() == PtexBlockHeader::Constant) {
        values.resize(nChannels);
        const void *pixel = block.bytes.data();
        if (block.bytes.empty()) pixel = color;
        std::memcpy(values.data(), pixel, nChannels * sizeof(T));
        for (size_t y = 0; y < height; ++y)
            for (size_t x = 0; x < width; ++x)
                std::copy(values.begin(), values.end(), to + (y * stride + x) * nChannels);
        return {};
    }
    values.resize(plane * nChannels);
    if (!Inflate(block.bytes, values.data(), values.size() * sizeof(T)))
        return "its texels cannot be inflated";
    if constexpr (std::is_integral_v<T>)
        if (block.header.BlockEncoding() == PtexBlockHeader::DiffZipped)
            std::partial_sum(values.begin(), values.end(), values.begin(),
                             [](T a, T b) { return T(a + b); });
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x)
            for (size_t c = 0; c < nChannels; ++c)
                to[(y * stride + x) * nChannels + c] = values[c * plane + y * width + x];
    return {};
}

template <typename T>
std::string Decode(const PtexBlock &block, size_t nChannels, const std::byte *color, T *to) {
    const size_t stride = size_t(1) << block.log2U;
    if (block.header.BlockEncoding() != PtexBlockHeader::Tiled)
        return DecodePlain(block, nChannels, color, stride, to);
    const std::optional<TileTable> table = ReadTileTable(block);
    if (!table) return kBadTiles;
    return table->ForEach(
        1 << (block.log2U - table->log2U), [&](const PtexBlock &tile, size_t x, size_t y) {
            const size_t first = (y << table->log2V) * stride + (x << table->log2U);
            return DecodePlain(tile, nChannels, color, stride, to + first * nChannels);
        });
}

}  // namespace

bool Inflate(std::string_view zipped, void *to, size_t size) {
    uLongf inflated = uLong(size);
    const int status =
        uncompress(static_cast<Bytef *>(to), &inflated,
                   reinterpret_cast<const Bytef *>(zipped.data()), uLong(zipped.size()));
    return status == Z_OK && inflated == size;
}

std::string CheckPtexBlock(const PtexBlock &block, const PtexTexels &layout,
                           uint64_t *constantBytes) {
    if (block.header.BlockEncoding() != PtexBlockHeader::Tiled)
        return CheckPlain(block, layout, constantBytes);
    const std::optional<TileTable> table = ReadTileTable(block);
    if (!table) return kBadTiles;
    return table->ForEach(1, [&](const PtexBlock &tile, size_t, size_t) {
        return CheckPlain(tile, layout, constantBytes);
    });
}

std::string DecodePtexBlock(const PtexBlock &block, const PtexTexels &layout,
                            const std::byte *color, std::byte *to) {
    return WithPtexType(layout.Type(), [&](auto t) {
        return Decode(block, size_t(layout.NChannels()), color,
                      reinterpret_cast<decltype(t) *>(to));
    });
}

}  // namespace pbrt
