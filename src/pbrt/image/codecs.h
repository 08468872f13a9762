#pragma once

#include <string>
#include <string_view>

#include "pbrt/image/exr_words.h"
#include "pbrt/image/image.h"
#include "pbrt/util/result.h"

// One file format each, between bytes in memory and Image. Errors are reasons without a file name:
// "is damaged: ...", as the rest of a sentence.

namespace pbrt {

OrError<Image> DecodeExr(std::string_view bytes);
OrError<Image> DecodePng(std::string_view bytes, const ColorEncoding &encoding);
OrError<Image> DecodeJpeg(std::string_view bytes, const ColorEncoding &encoding);
OrError<Image> DecodePfm(std::string_view bytes);
OrError<Image> DecodeHdr(std::string_view bytes);
/// Colors of a file that says it is linear are, whatever the encoding.
OrError<Image> DecodeQoi(std::string_view bytes, const ColorEncoding &encoding);
/// TGA has no mark at its start: this asks whether the bytes could be a header of it. Text cannot.
bool IsTga(std::string_view bytes);
OrError<Image> DecodeTga(std::string_view bytes, const ColorEncoding &encoding);

/// With `words`, if any, in a part of their own.
OrError<std::string> EncodeExr(const Image &image, ExrPixels pixels,
                               const ExrWords *words = nullptr);
OrError<ExrWords> DecodeExrWords(std::string_view bytes, const std::string &part);
OrError<std::string> EncodePng(const Image &image);
OrError<std::string> EncodePfm(const Image &image);

/// Request before memory is taken for an image: nullopt where `bytesInFile` may hold width x
/// height pixels of `channels` values, `bitsPerPixel` before compression, by a format that
/// compresses at most `maxRatio` times, and where there is memory for it as floats and as bytes of
/// that many bits; else the reason. Images of more than 2^31 values are refused.
std::optional<std::string> Implausible(double width, double height, double channels,
                                       double bitsPerPixel, double maxRatio, size_t bytesInFile);

/// The channels of WriteImage's PNG and PFM (and alpha where `withAlpha`), as R G B or Y, then A:
/// what formats without named channels can hold. Alpha is A, or A of a layer if there is but one.
OrError<Image> ForDisplay(const Image &image, bool withAlpha);

}  // namespace pbrt
