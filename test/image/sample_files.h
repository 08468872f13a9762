#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>
// jpeglib.h needs size_t and FILE before it.
#include <jpeglib.h>

namespace pbrt {

/// A smooth JPEG of quality 95: red grows with x, green with y, blue is 128; gray: grows with x.
/// `scans`: how a progressive file is cut up, or empty.
inline std::string SampleJpeg(int width, int height, bool gray, bool progressive = false,
                              const std::vector<jpeg_scan_info> &scans = {}) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char *bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &bytes, &size);
    info.image_width = width;
    info.image_height = height;
    info.input_components = gray ? 1 : 3;
    info.in_color_space = gray ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, 95, TRUE);
    if (progressive) jpeg_simple_progression(&info);
    if (!scans.empty()) info.scan_info = scans.data(), info.num_scans = int(scans.size());
    jpeg_start_compress(&info, TRUE);
    for (int y = 0; y < height; ++y) {
        std::string row;
        for (int x = 0; x < width; ++x) {
            row += char(255 * x / (width - 1));
            if (!gray) row += {char(255 * y / (height - 1)), char(128)};
        }
        JSAMPROW pointer = reinterpret_cast<JSAMPROW>(row.data());
        jpeg_write_scanlines(&info, &pointer, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    const std::string file(reinterpret_cast<char *>(bytes), size);
    std::free(bytes);
    return file;
}

/// Radiance HDR of 8 x 2 pixels: a run-length coded row (R = 1, G = x / 8, B = 0.5), a flat row of
/// 0.25.
inline std::string SampleHdr() {
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n";
    file += std::string("\x02\x02\x00\x08", 4);
    file += "\x88\x80";  // 8 times 128
    file += std::string("\x08\x00\x10\x20\x30\x40\x50\x60\x70", 9);
    file += "\x85\x40\x03\x40\x40\x40";  // 5 times 64, then three 64s
    file += "\x88\x81";                  // exponent 129: mantissa / 128
    for (int x = 0; x < 8; ++x)
        file += "\x80\x80\x80\x7f";
    return file;
}

}  // namespace pbrt
