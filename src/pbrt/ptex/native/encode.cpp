#include "pbrt/ptex/native/encode.h"

#include <zlib.h>

#include <new>
#include <numeric>
#include <type_traits>

namespace pbrt {
namespace {

/// Blocks of more bytes are written as tiles of at most this.
constexpr size_t kLargestBlock = 65536;

struct Block {
    PtexBlockHeader header;
    std::string bytes;

    Block() = default;
    Block(std::string contents, PtexBlockHeader::Encoding encoding)
        : header(uint32_t(contents.size()), encoding), bytes(std::move(contents)) {}
    void AddTo(PtexLevel *level) const {
        level->headers.push_back(header);
        level->blocks += bytes;
    }
};

/// A rectangle of the texels of a face that is `stride` texels wide.
template <typename T>
struct Window {
    const T *first;
    size_t stride, width, height, nChannels;

    const T *Row(size_t y) const { return first + y * stride * nChannels; }
    bool IsConstant() const {
        for (size_t y = 0; y < height; ++y)
            for (size_t i = 0; i < width * nChannels; ++i)
                if (Row(y)[i] != first[i % nChannels]) return false;
        return true;
    }
    /// Planes of channels; whole numbers as differences that run on through all of them.
    Block Zipped() const {
        std::vector<T> values;
        values.reserve(width * height * nChannels);
        for (size_t c = 0; c < nChannels; ++c)
            for (size_t y = 0; y < height; ++y)
                for (size_t x = 0; x < width; ++x)
                    values.push_back(Row(y)[x * nChannels + c]);
        if constexpr (!std::is_integral_v<T>) return {Zip(values), PtexBlockHeader::Zipped};
        std::adjacent_difference(values.begin(), values.end(), values.begin(),
                                 [](T a, T b) { return T(a - b); });
        return {Zip(values), PtexBlockHeader::DiffZipped};
    }
    Block Tile() const {
        if (!IsConstant()) return Zipped();
        return {std::string(reinterpret_cast<const char *>(first), nChannels * sizeof(T)),
                PtexBlockHeader::Constant};
    }
};

template <typename T>
Block Tiled(const Window<T> &face, int log2U, int log2V) {
    PtexLevel tiles;
    const size_t dx = size_t(1) << log2U, dy = size_t(1) << log2V;
    for (size_t y = 0; y < face.height; y += dy)
        for (size_t x = 0; x < face.width; x += dx)
            Window<T>{face.Row(y) + x * face.nChannels, face.stride, dx, dy, face.nChannels}
                .Tile()
                .AddTo(&tiles);
    const std::string headers = Zip(tiles.headers);
    std::string bytes;
    AppendBytes(&bytes, int8_t(log2U));
    AppendBytes(&bytes, int8_t(log2V));
    AppendBytes(&bytes, uint32_t(headers.size()));
    return {bytes + headers + tiles.blocks, PtexBlockHeader::Tiled};
}

template <typename T>
Block EncodeFace(const PtexTexels &texels, int face, int level) {
    int log2U = std::max(texels.Log2U(face) - level, 0);
    int log2V = std::max(texels.Log2V(face) - level, 0);
    const size_t width = size_t(1) << log2U;
    const Window<T> whole{texels.LevelAs<T>(face, level), width, width, size_t(1) << log2V,
                          size_t(texels.NChannels())};
    if ((texels.PixelSize() << (log2U + log2V)) <= kLargestBlock) return whole.Zipped();
    while ((texels.PixelSize() << (log2U + log2V)) > kLargestBlock && log2U + log2V > 0)
        --(log2U > log2V ? log2U : log2V);
    return Tiled(whole, log2U, log2V);
}

int Rank(const PtexTexels &texels, int face) {
    return PtexRank(texels.Log2U(face), texels.Log2V(face), texels.IsConstant(face));
}

template <typename T>
std::vector<PtexLevel> Encode(const PtexTexels &texels, bool reductions) {
    std::vector<PtexLevel> levels(1);
    for (int f = 0; f < texels.NFaces(); ++f)
        (texels.IsConstant(f) ? Block() : EncodeFace<T>(texels, f, 0)).AddTo(&levels[0]);
    if (!reductions) return levels;
    for (const int f : PtexReductionOrder(texels))
        for (int level = 1; level <= Rank(texels, f) - kPtexLeastLog2; ++level) {
            if (size_t(level) == levels.size()) levels.emplace_back();
            EncodeFace<T>(texels, f, level).AddTo(&levels[size_t(level)]);
        }
    return levels;
}

}  // namespace

std::string Zip(const void *data, size_t size) {
    uLongf zipped = compressBound(uLong(size));
    std::string out(zipped, '\0');
    // With room for the worst case it fails for want of memory only.
    if (compress(reinterpret_cast<Bytef *>(out.data()), &zipped, static_cast<const Bytef *>(data),
                 uLong(size)) != Z_OK)
        throw std::bad_alloc();
    out.resize(zipped);
    return out;
}

std::vector<int> PtexReductionOrder(const PtexTexels &texels) {
    std::vector<int> order(size_t(texels.NFaces()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return Rank(texels, a) > Rank(texels, b); });
    return order;
}

std::vector<PtexLevel> EncodeLevels(const PtexTexels &texels, bool reductions) {
    return WithPtexType(texels.Type(),
                        [&](auto t) { return Encode<decltype(t)>(texels, reductions); });
}

}  // namespace pbrt
