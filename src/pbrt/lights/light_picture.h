#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/lights/emission.h"

namespace pbrt {

/// A picture whose texels are spectra of light: RGB in the renderer's units, by which a texel of
/// RGB 1 has the CIE-Y integral 1. Constant within each texel.
class LightPicture {
  public:
    LightPicture() = default;
    /// The image, which has channels R, G, B, times `scale`; values below 0 count as 0.
    LightPicture(const Image &image, const RGBColorSpace &colorSpace, float scale = 1);
    /// One texel of that spectrum.
    LightPicture(const Emission &emission, float scale);
    /// The most memory that it takes, beside the image.
    static uint64_t BytesToCreate(const Image &image);

    Point2i Resolution() const { return resolution; }
    SampledSpectrum Sample(Point2i texel, const SampledWavelengths &lambda) const {
        const Texel &t = texels[size_t(texel.y) * size_t(resolution.x) + size_t(texel.x)];
        if (t.scale == 0) return SampledSpectrum(0.f);
        return t.sigmoid.Sample(lambda) * illuminant.Sample(lambda) * t.scale;
    }
    /// The texel at p, whose rows run downwards; outside [0, 1]^2 the nearest, for NaN the first.
    Point2i TexelAt(Point2f p) const {
        const auto at = [](float x, int n) {
            const float texel = x * float(n);
            return texel > 0 ? std::min(int(std::min(texel, 0x1p30f)), n - 1) : 0;
        };
        return {at(p.x, resolution.x), at(p.y, resolution.y)};
    }
    /// Twice the greatest component of a texel's RGB: for choosing directions.
    float Strength(Point2i texel) const {
        return texels[size_t(texel.y) * size_t(resolution.x) + size_t(texel.x)].scale;
    }
    float MeanLuminance() const { return meanLuminance; }
    const Spectrum &Illuminant() const { return illuminant; }

  private:
    struct Texel {
        RGBSigmoid sigmoid;
        float scale;
    };
    Point2i resolution{1, 1};
    std::vector<Texel> texels;
    Spectrum illuminant;  ///< of the picture's colors, CIE-Y integral 1
    float meanLuminance = 0;
};

/// RGB of a texel, none below 0.
RGB TexelRGB(const Image &image, int x, int y);
/// CIE Y of RGB in the renderer's units.
float Luminance(const RGB &rgb, const RGBColorSpace &space);

/// Demands that a light makes on its picture; `what` is the light, as in "an infinite light".
struct PictureNeeds {
    std::string_view what;
    bool square = false;     ///< equal-area octahedral
    bool mayBeGray = false;  ///< Y alone serves, too
};
/// The picture of the parameter `row`, whose pixels are finite; nullopt after an error.
std::optional<Image> ReadLightPicture(ParamDict &params, const StringParam &row,
                                      const PictureNeeds &needs);

}  // namespace pbrt
