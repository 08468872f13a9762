// QOI, the "Quite OK Image Format" (specification 1.0, 2022, qoiformat.org). Debian's qoi.h makes
// up the pixels that a truncated file lacks; here that is an error, and the format is a page.

#include <array>
#include <cstdint>

#include "pbrt/image/codecs.h"

namespace pbrt {
namespace {

using Bytes = std::string_view;
using Pixel = std::array<uint8_t, 4>;

constexpr size_t kHeaderSize = 14;
constexpr Bytes kEnd("\0\0\0\0\0\0\0\1", 8);

unsigned ByteAt(Bytes bytes, size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}
/// 32 bits, the high ones first.
uint32_t LongAt(Bytes bytes, size_t i) {
    return ByteAt(bytes, i) << 24 | ByteAt(bytes, i + 1) << 16 | ByteAt(bytes, i + 2) << 8 |
           ByteAt(bytes, i + 3);
}

/// The pixels of a file, one chunk after the other.
class ChunkReader {
  public:
    explicit ChunkReader(Bytes bytes) : bytes(bytes) {}

    /// The next pixel; false where the bytes end before it.
    bool Next(Pixel *next) {
        if (repeats > 0)
            --repeats;
        else if (!TakeChunk())
            return false;
        *next = pixel;
        return true;
    }
    Bytes Rest() const { return bytes; }

  private:
    bool TakeChunk() {
        const size_t size = bytes.empty() ? 1 : SizeOf(ByteAt(bytes, 0));
        if (bytes.size() < size) return false;
        const Bytes chunk = bytes.substr(0, size);
        bytes.remove_prefix(size);
        const unsigned tag = ByteAt(chunk, 0), low = tag & 63;
        if (tag >= 254)  // the colors, and alpha, as they are
            for (size_t c = 0; c + 1 < size; ++c)
                pixel[c] = uint8_t(ByteAt(chunk, c + 1));
        else if (tag >= 192)  // the pixel before, again and again
            repeats = low;
        else if (tag >= 128) {  // differences: green, those of red and blue from it
            const unsigned green = low - 32, more = ByteAt(chunk, 1);
            Add(green - 8 + (more >> 4), green, green - 8 + (more & 15));
        } else if (tag >= 64)  // small differences
            Add((low >> 4) - 2, (low >> 2 & 3) - 2, (low & 3) - 2);
        else
            pixel = seen[low];
        seen[(pixel[0] * 3u + pixel[1] * 5u + pixel[2] * 7u + pixel[3] * 11u) % 64] = pixel;
        return true;
    }
    static size_t SizeOf(unsigned tag) {
        if (tag == 255) return 5;
        if (tag == 254) return 4;
        return tag >> 6 == 2 ? 2 : 1;
    }
    /// Modulo 256.
    void Add(unsigned r, unsigned g, unsigned b) {
        pixel[0] = uint8_t(pixel[0] + r);
        pixel[1] = uint8_t(pixel[1] + g);
        pixel[2] = uint8_t(pixel[2] + b);
    }

    Bytes bytes;
    Pixel pixel{0, 0, 0, 255};
    unsigned repeats = 0;
    std::array<Pixel, 64> seen{};
};

}  // namespace

OrError<Image> DecodeQoi(Bytes bytes, const ColorEncoding &encoding) {
    const OrError<Image> tooShort{{}, "is damaged or ends too early"};
    if (bytes.size() < kHeaderSize) return tooShort;
    const uint32_t width = LongAt(bytes, 4), height = LongAt(bytes, 8);
    const unsigned channels = ByteAt(bytes, 12), isLinear = ByteAt(bytes, 13);
    if (channels < 3 || channels > 4 || isLinear > 1) return {{}, "is damaged: its header is none"};
    // A byte stands for 62 equal pixels at most.
    if (auto reason =
            Implausible(width, height, channels, 8 * channels, 62 * channels, bytes.size()))
        return {{}, *reason};

    std::array<float, 256> linear;
    for (size_t i = 0; i < linear.size(); ++i)
        linear[i] = (isLinear ? ColorEncoding{} : encoding).ToLinear(float(i) / 255);
    Image image({int(width), int(height)}, channels == 3
                                               ? std::vector<std::string>{"R", "G", "B"}
                                               : std::vector<std::string>{"R", "G", "B", "A"});
    ChunkReader reader(bytes.substr(kHeaderSize));
    Pixel pixel;
    for (size_t i = 0; i < image.Data().size(); i += channels) {
        if (!reader.Next(&pixel)) return tooShort;
        for (size_t c = 0; c < channels; ++c)
            image.Data()[i + c] = c < 3 ? linear[pixel[c]] : float(pixel[c]) / 255;
    }
    if (!reader.Rest().starts_with(kEnd)) return tooShort;
    image.metadata.storedAs = "8-bit";
    return {std::move(image), {}};
}

}  // namespace pbrt
