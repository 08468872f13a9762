#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstring>

#include "pbrt/image/codecs.h"

namespace pbrt {
namespace {

/// libpng's state for one file in memory. Errors inside libpng jump back into ReadHeader or
/// ReadRows, which therefore hold nothing that needs a destructor.
class PngReader {
  public:
    explicit PngReader(std::string_view bytes) : rest(bytes) {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, OnError, OnWarning);
        info = png ? png_create_info_struct(png) : nullptr;
    }
    PngReader(const PngReader &) = delete;
    PngReader &operator=(const PngReader &) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

    /// Reads up to the pixels and asks for gray or RGB, with or without alpha, in 8 or 16 bits of
    /// this machine's byte order; false on error.
    bool ReadHeader() {
        if (!info || setjmp(png_jmpbuf(png))) return false;
        png_set_read_fn(png, this, OnRead);
        png_read_info(png, info);
        png_set_expand(png);
        if (std::endian::native == std::endian::little) png_set_swap(png);
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        return true;
    }
    bool ReadRows(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_read_image(png, rows);
        png_read_end(png, nullptr);
        return true;
    }

    int Width() const { return int(png_get_image_width(png, info)); }
    int Height() const { return int(png_get_image_height(png, info)); }
    int Channels() const { return png_get_channels(png, info); }
    int BitDepth() const { return png_get_bit_depth(png, info); }
    size_t RowBytes() const { return png_get_rowbytes(png, info); }
    const char *Message() const { return message; }

  private:
    static void OnError(png_structp png, png_const_charp text) {
        auto *self = static_cast<PngReader *>(png_get_error_ptr(png));
        std::strncpy(self->message, text, sizeof self->message - 1);
        png_longjmp(png, 1);
    }
    static void OnWarning(png_structp, png_const_charp) {}
    static void OnRead(png_structp png, png_bytep out, size_t n) {
        auto *self = static_cast<PngReader *>(png_get_io_ptr(png));
        if (n > self->rest.size()) png_error(png, "it ends too early");
        std::memcpy(out, self->rest.data(), n);
        self->rest.remove_prefix(n);
    }

    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string_view rest;
    char message[128] = "out of memory";
};

std::vector<std::string> PngChannels(int n) {
    switch (n) {
        case 1:
            return {"Y"};
        case 2:
            return {"Y", "A"};
        case 3:
            return {"R", "G", "B"};
        default:
            return {"R", "G", "B", "A"};
    }
}

/// One linear value per code.
std::vector<float> DecodingTable(int bits, const ColorEncoding &encoding) {
    std::vector<float> table(size_t(1) << bits);
    for (size_t i = 0; i < table.size(); ++i)
        table[i] = encoding.ToLinear(float(i) / float(table.size() - 1));
    return table;
}

}  // namespace

OrError<Image> DecodePng(std::string_view bytes, const ColorEncoding &encoding) {
    PngReader reader(bytes);
    const auto damaged = [&] { return fmt::format("is damaged: {}", reader.Message()); };
    if (!reader.ReadHeader()) return {{}, damaged()};
    const int width = reader.Width(), height = reader.Height(), channels = reader.Channels();
    // Deflate reaches 1032:1; palettes of 1 bit become up to 32.
    if (auto reason = Implausible(width, height, channels, 8. * reader.RowBytes() / width,
                                  32 * 1032, bytes.size()))
        return {{}, *reason};

    std::vector<unsigned char> data(reader.RowBytes() * height);
    std::vector<png_bytep> rows(height);
    for (int y = 0; y < height; ++y)
        rows[y] = &data[y * reader.RowBytes()];
    if (!reader.ReadRows(rows.data())) return {{}, damaged()};

    Image image({width, height}, PngChannels(channels));
    const bool wide = reader.BitDepth() == 16;
    const std::vector<float> linear = DecodingTable(wide ? 16 : 8, encoding);
    const std::vector<float> alpha = DecodingTable(wide ? 16 : 8, ColorEncoding{});
    const auto codeAt = [&](size_t i) -> size_t {
        if (!wide) return data[i];
        uint16_t code;
        std::memcpy(&code, &data[2 * i], 2);
        return code;
    };
    const bool hasAlpha = channels % 2 == 0;
    for (size_t i = 0; i < image.Data().size(); ++i) {
        const bool isAlpha = hasAlpha && int(i % channels) == channels - 1;
        image.Data()[i] = (isAlpha ? alpha : linear)[codeAt(i)];
    }
    image.metadata.storedAs = wide ? "16-bit" : "8-bit";
    return {std::move(image), {}};
}

OrError<std::string> EncodePng(const Image &source) {
    const OrError<Image> image = ForDisplay(source, true);
    if (!image) return {{}, image.error};
    const int channels = image.value->NChannels();
    const ColorEncoding sRGB{ColorEncoding::Kind::sRGB, 1};
    std::vector<unsigned char> codes(image.value->Data().size());
    for (size_t i = 0; i < codes.size(); ++i) {
        const float linear = image.value->Data()[i];
        const bool isAlpha = channels % 2 == 0 && int(i % channels) == channels - 1;
        const float code = isAlpha ? linear : sRGB.FromLinear(linear);
        codes[i] = code > 0 ? (unsigned char)(std::min(code, 1.f) * 255 + 0.5f) : 0;  // NaN: 0
    }

    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(image.value->Resolution().x);
    png.height = png_uint_32(image.value->Resolution().y);
    constexpr png_uint_32 kFormats[] = {PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB,
                                        PNG_FORMAT_RGBA};
    png.format = kFormats[channels - 1];
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, codes.data(), 0, nullptr))
        return {{}, fmt::format("cannot be written: {}", png.message)};
    bytes.resize(size);
    return {std::move(bytes), {}};
}

}  // namespace pbrt
