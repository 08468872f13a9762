#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pbrt/image/image.h"

namespace pbrt {

/// Which samples of which render a picture holds, as its metadata say in three texts: `sceneHash`,
/// `seed` ("0", or "0,1" for an average) and `sampleRange` ("0:64 of 256").
struct Origin {
    std::string scene;  ///< hexadecimal digits: of scene text, assets and options
    std::vector<int> seeds;
    int first = 0, last = 0;  ///< samples [first, last) of each pixel
    int whole = 0;            ///< of as many

    bool IsWhole() const { return first == 0 && last == whole; }
};

/// nullopt where the metadata do not say.
std::optional<Origin> OriginOf(const ImageMetadata &metadata);
void SetOrigin(const Origin &origin, ImageMetadata *metadata);
void ClearOrigin(ImageMetadata *metadata);

/// True where both hold the same samples of the same pixels, or some of them.
bool ShareSamples(const ImageMetadata &a, const ImageMetadata &b);

}  // namespace pbrt
