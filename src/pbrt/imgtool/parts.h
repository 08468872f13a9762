#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pbrt/image/exr_words.h"
#include "pbrt/image/image.h"
#include "pbrt/image/origin.h"
#include "pbrt/util/result.h"

namespace pbrt::imgtool {

/// A picture of some samples, or some pixels, of a render.
struct Part {
    std::string file;
    Image image;
    std::optional<Origin> origin;
    ExrWords sums;  ///< perPixel 0: the file has none
};

/// Reads it; with `needsOrigin` a file that does not say which samples it holds is refused.
OrError<Part> ReadPart(const std::string &file, bool needsOrigin, std::string *remarks);

/// Why these cannot be parts of one picture: other scenes, seeds, numbers of samples, films or
/// channels, or two that hold the same samples of the same pixels. It names the two files.
std::optional<std::string> WhyNotOne(std::span<const Part> parts);

/// Parts joined.
struct Merged {
    Image image;
    ExrWords sums;        ///< perPixel 0: all samples are there
    int64_t missing = 0;  ///< pixels that no part has; they are 0
};

/// Pixels that no part has are refused, or left out.
enum class Gaps { Refused, Black };

/// Joins the parts: pixels of which a part has all samples are copied, of the others the exact sums
/// are added and developed, so that the result has the bits of a render of the whole. The image
/// covers the parts' pixels; with Gaps::Black all of the full picture's.
OrError<Merged> Merge(std::span<const Part> parts, Gaps gaps);

}  // namespace pbrt::imgtool
