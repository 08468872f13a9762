// Truevision TGA (TGA File Format Specification 2.0, 1991). Debian's one small reader, stb_image,
// is not made for damaged files, and says so; the format is small enough to need none.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pbrt/image/codecs.h"

namespace pbrt {
namespace {

using Bytes = std::string_view;

unsigned ByteAt(Bytes bytes, size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}
/// 16 bits, the low ones first.
unsigned ShortAt(Bytes bytes, size_t i) {
    return ByteAt(bytes, i) + 256 * ByteAt(bytes, i + 1);
}

constexpr size_t kHeaderSize = 18;
enum class Kind { Palette = 1, Color = 2, Gray = 3 };

struct Header {
    explicit Header(Bytes bytes)
        : nameLength(ByteAt(bytes, 0)),
          kind(Kind(ByteAt(bytes, 2) & 7)),
          isPacked((ByteAt(bytes, 2) & 8) != 0),
          firstEntry(ShortAt(bytes, 3)),
          nEntries(ByteAt(bytes, 1) != 0 ? ShortAt(bytes, 5) : 0),
          entryBits(ByteAt(bytes, 7)),
          width(int(ShortAt(bytes, 12))),
          height(int(ShortAt(bytes, 14))),
          bits(ByteAt(bytes, 16)),
          alphaBits(ByteAt(bytes, 17) & 15),
          fromRight((ByteAt(bytes, 17) & 16) != 0),
          fromTop((ByteAt(bytes, 17) & 32) != 0),
          isInterleaved((ByteAt(bytes, 17) & 192) != 0) {}

    size_t nameLength;
    Kind kind;
    bool isPacked;
    unsigned firstEntry, nEntries, entryBits;
    int width, height;
    unsigned bits, alphaBits;
    bool fromRight, fromTop, isInterleaved;
};

size_t BytesOf(unsigned bits) {
    return (bits + 7) / 8;
}
bool IsColorBits(unsigned bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

/// Why no such picture is read, as the rest of a sentence; empty where it is.
std::string Unfit(const Header &h) {
    const bool hasGoodBits =
        h.kind == Kind::Color ? IsColorBits(h.bits) : h.bits == 8 || h.bits == 16;
    if (!hasGoodBits) return fmt::format("is damaged: a TGA picture of {} bits a pixel", h.bits);
    if (h.kind == Kind::Palette && (h.nEntries == 0 || !IsColorBits(h.entryBits)))
        return fmt::format("is damaged: a palette of {} colors of {} bits", h.nEntries,
                           h.entryBits);
    if (h.isInterleaved) return "is a TGA picture of interleaved rows, which are not supported";
    return {};
}

/// A pixel's stored bytes as linear values.
class PixelDecoder {
  public:
    /// `bits`: 8 or 16 of gray; 15, 16, 24 or 32 of color.
    PixelDecoder(bool isGray, unsigned bits, const ColorEncoding &encoding)
        : isGray(isGray),
          isOf5Bits(!isGray && bits <= 16),
          channels(isGray       ? int(bits) / 8
                   : bits == 32 ? 4
                                : 3) {
        const size_t n = isOf5Bits ? 32 : 256;
        for (size_t i = 0; i < n; ++i)
            linear[i] = encoding.ToLinear(float(i) / float(n - 1));
    }
    int NChannels() const { return channels; }
    /// Channels in the order of Image. The single bit beside 15 of color is no alpha: few programs
    /// set it on purpose.
    void Decode(Bytes code, float *out) const {
        if (isOf5Bits) {
            const unsigned all = ShortAt(code, 0);
            for (int c = 0; c < 3; ++c)
                out[c] = linear[all >> (10 - 5 * c) & 31];
            return;
        }
        const int nColors = isGray ? 1 : 3;
        for (int c = 0; c < nColors; ++c)  // stored as blue, green, red
            out[c] = linear[ByteAt(code, size_t(nColors - 1 - c))];
        if (channels > nColors) out[nColors] = float(ByteAt(code, size_t(nColors))) / 255;
    }

  private:
    bool isGray, isOf5Bits;
    int channels;
    std::array<float, 256> linear{};
};

/// Undoes the run lengths: a byte below 128 and that many pixels and one; or, from 128 on, one
/// pixel for so many. Empty where the bytes do not fill the picture, or overfill it.
std::string Unpacked(Bytes bytes, size_t pixels, size_t pixelSize) {
    std::string all;
    all.reserve(pixels * pixelSize);
    while (all.size() < pixels * pixelSize) {
        if (bytes.empty()) return {};
        const bool isRun = ByteAt(bytes, 0) >= 128;
        const size_t n = ByteAt(bytes, 0) % 128 + 1, taken = (isRun ? 1 : n) * pixelSize;
        if (bytes.size() < 1 + taken || n > pixels - all.size() / pixelSize) return {};
        for (size_t i = 0; i < (isRun ? n : 1); ++i)
            all += bytes.substr(1, taken);
        bytes.remove_prefix(1 + taken);
    }
    return all;
}

std::vector<std::string> ChannelNames(int n) {
    if (n == 1) return {"Y"};
    if (n == 2) return {"Y", "A"};
    if (n == 3) return {"R", "G", "B"};
    return {"R", "G", "B", "A"};
}

/// An alpha that the file does not promise and that is 0 everywhere is none.
bool IsAlphaUnused(const Image &image, const Header &h) {
    if (image.NChannels() != 4 || h.alphaBits != 0) return false;
    for (size_t i = 3; i < image.Data().size(); i += 4)
        if (image.Data()[i] != 0) return false;
    return true;
}
Image WithoutAlpha(const Image &image) {
    Image colors(image.Resolution(), ChannelNames(3));
    for (size_t i = 0; i < colors.Data().size(); ++i)
        colors.Data()[i] = image.Data()[i / 3 * 4 + i % 3];
    return colors;
}

/// Pixels from their stored bytes, by the palette where there is one; nullopt where a pixel has no
/// entry there.
std::optional<Image> Decoded(const Header &h, Bytes palette, Bytes pixels,
                             const PixelDecoder &decoder) {
    const size_t pixelSize = BytesOf(h.bits), entrySize = BytesOf(h.entryBits);
    Image image({h.width, h.height}, ChannelNames(decoder.NChannels()));
    for (int row = 0; row < h.height; ++row)
        for (int column = 0; column < h.width; ++column) {
            Bytes code = pixels.substr(0, pixelSize);
            pixels.remove_prefix(pixelSize);
            if (h.kind == Kind::Palette) {
                const size_t index = h.bits == 8 ? ByteAt(code, 0) : ShortAt(code, 0);
                if (index < h.firstEntry || index - h.firstEntry >= h.nEntries) return std::nullopt;
                code = palette.substr((index - h.firstEntry) * entrySize, entrySize);
            }
            const Point2i at{h.fromRight ? h.width - 1 - column : column,
                             h.fromTop ? row : h.height - 1 - row};
            decoder.Decode(code, image.Pixel(at));
        }
    return image;
}

}  // namespace

bool IsTga(Bytes bytes) {
    if (bytes.size() < kHeaderSize || ByteAt(bytes, 1) > 1) return false;
    const unsigned kind = ByteAt(bytes, 2) & ~8u;
    return kind >= unsigned(Kind::Palette) && kind <= unsigned(Kind::Gray);
}

OrError<Image> DecodeTga(Bytes bytes, const ColorEncoding &encoding) {
    const Header h(bytes);
    if (const std::string unfit = Unfit(h); !unfit.empty()) return {{}, unfit};
    const bool isOfPalette = h.kind == Kind::Palette;
    const PixelDecoder decoder(h.kind == Kind::Gray, isOfPalette ? h.entryBits : h.bits, encoding);
    const size_t pixelSize = BytesOf(h.bits), n = size_t(h.width) * size_t(h.height);
    // A run of 128 pixels takes a byte and a pixel.
    if (auto reason = Implausible(h.width, h.height, decoder.NChannels(), double(8 * pixelSize),
                                  h.isPacked ? 128 : 1, bytes.size()))
        return {{}, *reason};
    const OrError<Image> tooShort{{}, "is damaged or ends too early"};
    const size_t paletteSize = h.nEntries * BytesOf(h.entryBits);
    const size_t start = kHeaderSize + h.nameLength + paletteSize;
    if (bytes.size() < start) return tooShort;
    const Bytes palette = bytes.substr(start - paletteSize, paletteSize);
    bytes.remove_prefix(start);
    std::string unpacked;
    if (h.isPacked) {
        unpacked = Unpacked(bytes, n, pixelSize);
        bytes = unpacked;
    }
    if (bytes.size() < n * pixelSize) return tooShort;
    std::optional<Image> image = Decoded(h, palette, bytes, decoder);
    if (!image) return {{}, "is damaged: a pixel has no color in the palette"};
    if (IsAlphaUnused(*image, h)) image = WithoutAlpha(*image);
    image->metadata.storedAs = "8-bit";
    return {std::move(image), {}};
}

}  // namespace pbrt
