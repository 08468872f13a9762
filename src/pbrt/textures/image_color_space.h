#pragma once

#include "pbrt/image/image.h"
#include "pbrt/image/primaries.h"
#include "pbrt/spectra/color.h"

namespace pbrt {

/// Colour space of an image's RGB: the known one with its chromaticities, else sRGB.
inline const RGBColorSpace &ColorSpaceOf(const Image &image) {
    if (const auto &xy = image.metadata.chromaticities)
        for (std::string_view name : RGBColorSpace::Names())
            if (const RGBColorSpace *space = RGBColorSpace::Named(name);
                SamePrimaries(space->Chromaticities(), *xy))
                return *space;
    return RGBColorSpace::sRGB();
}

}  // namespace pbrt
