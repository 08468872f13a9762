#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/util/result.h"

namespace pbrt {

/// Whole numbers of 32 bits beside a picture, `perPixel` for each of its pixels, row by row: what
/// floats cannot hold. In an OpenEXR file they are a second part, whose channels are unsigned
/// integers; programs that know nothing of them see the picture, which is the first part.
struct ExrWords {
    std::string name;                            ///< of the part
    std::map<std::string, std::string> strings;  ///< its attributes
    size_t perPixel = 0;
    std::vector<uint32_t> values;
};

/// WriteImage of an .exr file with such a part.
std::optional<std::string> WriteImageWithWords(const Image &image, const std::string &fileName,
                                               ExrPixels pixels, const ExrWords &words);
/// The part `name` of a file; `perPixel` is 0 where there is none.
OrError<ExrWords> ReadWords(const std::string &fileName, const std::string &name);

}  // namespace pbrt
