// Portable float map: three lines of text, then raw floats, the lowest row first. Small enough to
// need no library.

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "pbrt/image/codecs.h"
#include "pbrt/util/parse_number.h"

namespace pbrt {
namespace {

/// The next word of the header, removed together with the one white space after it.
std::string_view TakeWord(std::string_view *bytes) {
    constexpr std::string_view kSpace = " \t\r\n";
    const size_t begin = std::min(bytes->find_first_not_of(kSpace), bytes->size());
    const size_t end = std::min(bytes->find_first_of(kSpace, begin), bytes->size());
    const std::string_view word = bytes->substr(begin, end - begin);
    bytes->remove_prefix(std::min(end + 1, bytes->size()));
    return word;
}

float SwapBytes(float f) {
    const uint32_t u = std::bit_cast<uint32_t>(f);
    return std::bit_cast<float>((u >> 24) | ((u >> 8) & 0xff00) | ((u << 8) & 0xff0000) |
                                (u << 24));
}

}  // namespace

OrError<Image> DecodePfm(std::string_view bytes) {
    const std::string_view magic = TakeWord(&bytes);
    if (magic != "PF" && magic != "Pf") return {{}, "is damaged: it starts as PFM, but is none"};
    const bool gray = magic == "Pf";
    const auto columns = ParseWhole<int>(TakeWord(&bytes));
    const auto rows = ParseWhole<int>(TakeWord(&bytes));
    // The sign of the scale tells the byte order.
    const float scale = ParseWhole<float>(TakeWord(&bytes)).value_or(0);
    if (!columns || !rows || scale == 0 || !std::isfinite(scale))
        return {{}, "is damaged: its PFM header is not \"width height scale\""};
    const int width = *columns, height = *rows;
    const int channels = gray ? 1 : 3;
    if (auto reason = Implausible(width, height, channels, 32 * channels, 1, bytes.size()))
        return {{}, *reason};

    Image image({width, height},
                gray ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"});
    const size_t row = size_t(width) * channels;
    for (int y = 0; y < height; ++y)
        std::memcpy(&image.Data()[(height - 1 - y) * row], &bytes[y * row * 4], row * 4);
    if ((scale > 0) != (std::endian::native == std::endian::big))
        for (float &v : image.Data())
            v = SwapBytes(v);
    if (std::abs(scale) != 1)
        for (float &v : image.Data())
            v *= std::abs(scale);
    image.metadata.storedAs = "float";
    return {std::move(image), {}};
}

OrError<std::string> EncodePfm(const Image &source) {
    const OrError<Image> image = ForDisplay(source, false);
    if (!image) return {{}, image.error};
    const auto [width, height] = image.value->Resolution();
    const bool gray = image.value->NChannels() == 1;
    const bool bigEndian = std::endian::native == std::endian::big;
    std::string bytes =
        fmt::format("{}\n{} {}\n{}\n", gray ? "Pf" : "PF", width, height, bigEndian ? 1 : -1);
    const size_t row = size_t(width) * image.value->NChannels() * 4;
    for (int y = height - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char *>(image.value->Pixel({0, y})), row);
    return {std::move(bytes), {}};
}

}  // namespace pbrt
