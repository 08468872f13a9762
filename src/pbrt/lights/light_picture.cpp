#include "pbrt/lights/light_picture.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 3> kColors{"R", "G", "B"};

/// Why the picture does not serve, as the rest of a sentence; empty where it does.
std::string Unfit(const Image &image, const PictureNeeds &needs) {
    const Point2i res = image.Resolution();
    if (needs.square && res.x != res.y)
        return fmt::format(
            "is {} x {} pixels; {} needs a square picture in the equal-area octahedral layout, "
            "which "
            "\"imgtool makeequiarea\" makes of one of 2:1",
            res.x, res.y, needs.what);
    if (res.x < 1 || res.y < 1) return "has no pixels";
    const bool isGray = needs.mayBeGray && image.ChannelIndex("Y") >= 0;
    for (std::string_view name : kColors)
        if (!isGray && image.ChannelIndex(name) < 0)
            return fmt::format("has no channel {}; {} needs R, G and B{}", name, needs.what,
                               needs.mayBeGray ? ", or Y" : "");
    for (float v : image.Data())
        if (!std::isfinite(v)) return "has pixels that are not finite";
    return {};
}

}  // namespace

RGB TexelRGB(const Image &image, int x, int y) {
    RGB rgb;
    for (int c = 0; c < 3; ++c)
        rgb[c] = std::max(0.f, image.Get({x, y}, image.ChannelIndex(kColors[size_t(c)])));
    return rgb;
}

float Luminance(const RGB &rgb, const RGBColorSpace &space) {
    return Mul(space.XYZFromRGB(), {rgb.r, rgb.g, rgb.b})[1];
}

uint64_t LightPicture::BytesToCreate(const Image &image) {
    return uint64_t(image.Resolution().x) * uint64_t(image.Resolution().y) * sizeof(Texel);
}

LightPicture::LightPicture(const Image &image, const RGBColorSpace &colorSpace, float scale)
    : resolution(image.Resolution()) {
    const Spectrum &white = colorSpace.Illuminant();
    illuminant = white.Densely().Scaled(1 / SpectrumToPhotometric(white));
    texels.reserve(size_t(resolution.x) * size_t(resolution.y));
    double luminance = 0;
    for (int y = 0; y < resolution.y; ++y)
        for (int x = 0; x < resolution.x; ++x) {
            const RGB rgb = TexelRGB(image, x, y);
            // Twice the largest component, so that the sigmoid stays away from its ends.
            const float m = 2 * rgb.Max();
            const RGBSigmoid sigmoid =
                m > 0 ? colorSpace.LookUpSigmoid(rgb * (1 / m)) : RGBSigmoid{};
            texels.push_back({sigmoid, m * scale});
            luminance += double(Luminance(rgb, colorSpace));
        }
    meanLuminance = float(luminance / double(texels.size())) * scale;
}

LightPicture::LightPicture(const Emission &emission, float scale)
    : texels{{RGBSigmoid{}, 2 * scale}},  // the sigmoid of zeros is 1/2
      illuminant(*emission.spectrum),
      meanLuminance(emission.luminance * scale) {}

std::optional<Image> ReadLightPicture(ParamDict &params, const StringParam &row,
                                      const PictureNeeds &needs) {
    const std::string file = params.GetFileName(row);
    if (file.empty()) {
        params.Error(fmt::format("{} needs \"string {}\", a picture", params.What(), row.name));
        return std::nullopt;
    }
    OrError<Image> image = ReadImage(file);
    std::string unfit = image ? Unfit(*image.value, needs) : std::string();
    if (image && unfit.empty())
        if (const auto why = WhyTooLarge(LightPicture::BytesToCreate(*image.value)))
            unfit = fmt::format("as a light {}", *why);
    if (!image || !unfit.empty()) {
        params.Error(row.name, image ? fmt::format("\"{}\" {}", file, unfit) : image.error);
        return std::nullopt;
    }
    if (const std::string &unread = image.value->metadata.unread; !unread.empty())
        params.WarningOnce(row.name, fmt::format("{}: {}", file, unread));
    return std::move(image.value);
}

}  // namespace pbrt
