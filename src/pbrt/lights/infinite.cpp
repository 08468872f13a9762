#include "pbrt/lights/infinite.h"

#include <fmt/format.h>

#include "pbrt/textures/image_color_space.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

constexpr StringParam kFileName{"filename", "",
                                "square picture of all directions, equal-area octahedral"};

/// Why the picture cannot light a scene; empty where it can.
std::string Unfit(const Image &image) {
    const Point2i res = image.Resolution();
    if (res.x != res.y)
        return fmt::format(
            "is {} x {} pixels; an infinite light needs a square picture in the "
            "equal-area octahedral layout",
            res.x, res.y);
    if (res.x < 1) return "has no pixels";
    for (std::string_view name : {"R", "G", "B"})
        if (image.ChannelIndex(name) < 0)
            return fmt::format("has no channel {}; an infinite light needs R, G and B", name);
    for (float v : image.Data())
        if (!std::isfinite(v)) return "has pixels that are not finite";
    const auto why = WhyTooLarge(ImageInfiniteLight::BytesToCreate(image));
    return why ? fmt::format("as a light {}", *why) : std::string();
}

}  // namespace

std::optional<std::variant<UniformInfiniteLight, ImageInfiniteLight>> CreateInfiniteLight(
    ParamDict &params, const Transform &renderFromLight) {
    const std::string file = params.GetFileName(kFileName);
    const EmissionScale scale = GetScale(params, kLightIlluminance);
    if (file.empty()) {
        const Emission emission = GetEmission(params, kLightRadiance);
        UniformInfiniteLight light;
        light.radiance = emission.spectrum;
        light.luminance = emission.luminance;
        // Illuminance of a patch under the hemisphere of radiance 1.
        light.scale = scale.For(Pi);
        return light;
    }
    if (params.GetOneSpectrum(kLightRadiance))
        params.Error(kLightRadiance.name,
                     "both \"L\" and \"filename\" are given; an infinite light takes one");
    const OrError<Image> image = ReadImage(file);
    const std::string unfit = image ? Unfit(*image.value) : std::string();
    if (!image || !unfit.empty()) {
        params.Error(kFileName.name, image ? fmt::format("\"{}\" {}", file, unfit) : image.error);
        return std::nullopt;
    }
    if (const std::string &unread = image.value->metadata.unread; !unread.empty())
        params.WarningOnce(kFileName.name, fmt::format("{}: {}", file, unread));
    const RGBColorSpace &space = ColorSpaceOf(*image.value);
    const float illuminance = ImageInfiniteLight::Illuminance(*image.value, space);
    if (scale.target > 0 && !(illuminance > 0)) {
        params.Error(kLightIlluminance.name,
                     "the picture is black above the horizon: no scale can give it "
                     "an illuminance");
        return std::nullopt;
    }
    return ImageInfiniteLight::FromImage(*image.value, space, scale.For(illuminance),
                                         renderFromLight);
}

}  // namespace pbrt
