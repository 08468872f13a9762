#pragma once

#include <string>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/spectra/color.h"
#include "pbrt/util/result.h"

// Operations on whole images that several commands share.

namespace pbrt::imgtool {

/// Pixels [x0, x1) x [y0, y1) of the stored ones; {x0, x1, y0, y1} as `--crop` gives them, a
/// negative x1 or y1 being an extent. The bounds in the metadata follow.
OrError<Image> Crop(const Image &image, const std::vector<int> &crop);

/// Reads. What of the file was left unread is added to `remarks`, a line for a file. `encoding`:
/// see ReadImage.
OrError<Image> Read(const std::string &fileName, std::string *remarks,
                    std::optional<ColorEncoding> encoding = {});

/// Reads, selects (nothing where `channels` is empty) and crops (likewise). Errors name the file.
OrError<Image> ReadPart(const std::string &fileName, const std::vector<std::string> &channels,
                        const std::vector<int> &crop, std::string *remarks);

/// The color space of the image's chromaticities, sRGB where it says none; null where it is none of
/// RGBColorSpace::Names().
const RGBColorSpace *ColorSpaceOf(const Image &image);

/// Why two images cannot be compared pixel by pixel: sizes, channels or color spaces differ.
std::optional<std::string> Mismatch(const Image &a, const Image &b);

/// Files an argument means: itself where it exists, else all whose names begin with it, sorted.
/// Empty where there are none.
std::vector<std::string> FilesOf(const std::string &nameOrPrefix);
/// The same for several arguments, or the reason why one means nothing.
OrError<std::vector<std::string>> FilesOf(const std::vector<std::string> &namesOrPrefixes);

}  // namespace pbrt::imgtool
