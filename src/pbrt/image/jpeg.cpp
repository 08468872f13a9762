#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>
// jpeglib.h needs size_t and FILE before it.
#include <jerror.h>
#include <jpeglib.h>

#include "pbrt/image/codecs.h"

namespace pbrt {
namespace {

/// libjpeg's state for one file in memory. Errors inside libjpeg jump back into ReadHeader or
/// ReadRows, which therefore hold nothing that needs a destructor.
class JpegReader {
  public:
    JpegReader() {
        info.err = jpeg_std_error(&errors.manager);
        errors.manager.error_exit = OnError;
        errors.manager.emit_message = OnWarning;
    }
    JpegReader(const JpegReader &) = delete;
    JpegReader &operator=(const JpegReader &) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&info); }

    bool ReadHeader(std::string_view bytes) {
        if (setjmp(errors.jump)) return false;
        jpeg_create_decompress(&info);
        info.progress = &progress;
        progress.progress_monitor = OnProgress;
        jpeg_mem_src(&info, reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size());
        jpeg_read_header(&info, TRUE);
        info.out_color_space = info.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
        jpeg_calc_output_dimensions(&info);
        return true;
    }
    /// `rows`: one pointer per row.
    bool ReadRows(JSAMPARRAY rows) {
        if (setjmp(errors.jump)) return false;
        jpeg_start_decompress(&info);
        while (info.output_scanline < info.output_height)
            jpeg_read_scanlines(&info, rows + info.output_scanline,
                                info.output_height - info.output_scanline);
        jpeg_finish_decompress(&info);
        return true;
    }

    int Width() const { return int(info.output_width); }
    int Height() const { return int(info.output_height); }
    int Channels() const { return info.num_components == 1 ? 1 : 3; }
    const char *Message() const { return errors.message; }

  private:
    struct Errors {
        jpeg_error_mgr manager;  ///< first, so that libjpeg's pointer to it is one to Errors
        std::jmp_buf jump;
        char message[JMSG_LENGTH_MAX] = "";
    };
    static void OnError(j_common_ptr info) {
        auto *errors = reinterpret_cast<Errors *>(info->err);
        info->err->format_message(info, errors->message);
        std::longjmp(errors->jump, 1);
    }
    /// libjpeg would go on with gray where data are missing: errors here. Bytes too many and header
    /// versions do no harm.
    static void OnWarning(j_common_ptr info, int level) {
        const int code = info->err->msg_code;
        if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_JFIF_MAJOR &&
            code != JWRN_ADOBE_XFORM)
            OnError(info);
    }

    /// A progressive file passes over the image scan by scan: few bytes can ask for thousands.
    static void OnProgress(j_common_ptr info) {
        constexpr int kMostScans = 500;
        if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= kMostScans) return;
        auto *errors = reinterpret_cast<Errors *>(info->err);
        std::snprintf(errors->message, sizeof errors->message, "more than %d scans", kMostScans);
        std::longjmp(errors->jump, 1);
    }

    jpeg_decompress_struct info{};
    jpeg_progress_mgr progress{};
    Errors errors;
};

}  // namespace

OrError<Image> DecodeJpeg(std::string_view bytes, const ColorEncoding &encoding) {
    JpegReader reader;
    const auto damaged = [&] { return fmt::format("is damaged: {}", reader.Message()); };
    if (!reader.ReadHeader(bytes)) return {{}, damaged()};
    const int width = reader.Width(), height = reader.Height(), channels = reader.Channels();
    // Flat blocks of 64 pixels can share a few bits.
    if (auto reason = Implausible(width, height, channels, 8 * channels, 4096, bytes.size()))
        return {{}, *reason};

    std::vector<unsigned char> data(size_t(width) * height * channels);
    std::vector<JSAMPROW> rows(height);
    for (int y = 0; y < height; ++y)
        rows[y] = &data[size_t(y) * width * channels];
    if (!reader.ReadRows(rows.data())) return {{}, damaged()};

    Image image({width, height}, channels == 1 ? std::vector<std::string>{"Y"}
                                               : std::vector<std::string>{"R", "G", "B"});
    float linear[256];
    for (int i = 0; i < 256; ++i)
        linear[i] = encoding.ToLinear(float(i) / 255);
    for (size_t i = 0; i < data.size(); ++i)
        image.Data()[i] = linear[data[i]];
    image.metadata.storedAs = "8-bit";
    return {std::move(image), {}};
}

}  // namespace pbrt
