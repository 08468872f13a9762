#include "pbrt/lights/image_infinite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "pbrt/textures/image_color_space.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

RGB TexelRGB(const Image &image, int x, int y) {
    static constexpr std::array<std::string_view, 3> kNames{"R", "G", "B"};
    RGB rgb;
    for (int c = 0; c < 3; ++c)
        rgb[c] = std::max(0.f, image.Get({x, y}, image.ChannelIndex(kNames[size_t(c)])));
    return rgb;
}

float Luminance(const RGB &rgb, const RGBColorSpace &space) {
    return Mul(space.XYZFromRGB(), {rgb.r, rgb.g, rgb.b})[1];
}

float AbsDeterminant(const Transform &t) {
    const Vector3f x = t.Vector({1, 0, 0}), y = t.Vector({0, 1, 0}), z = t.Vector({0, 0, 1});
    return std::abs(Dot(x, Cross(y, z)));
}

/// MIS compensation: what lies above the mean; everything alike where nothing does.
PiecewiseConstant2D Compensated(std::vector<float> weights, int resolution) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const float mean = float(sum / double(weights.size()));
    for (float &w : weights)
        w = std::max(0.f, w - mean);
    return PiecewiseConstant2D(weights, resolution, resolution);
}

/// The second integral of the height 1 - s^2 above the horizon, 0 below it (s > 1), from s = 0.
double HeightTwiceIntegrated(double s) {
    return s <= 1 ? s * s * (0.5 - s * s / 12) : 5. / 12 + 2. / 3 * (s - 1);
}

/// Integral over [a0, a1] x [b0, b1], none of it below 0, of the height at a + b.
double HeightOver(double a0, double a1, double b0, double b1) {
    // Below the horizon the differences would leave rounding errors, which bright texels multiply;
    // what lies within 1e-12 of it above counts for nothing.
    const bool isEmpty = a1 <= a0 || b1 <= b0, isBelow = a0 + b0 >= 1 - 1e-12;
    if (isEmpty || isBelow) return 0;
    return HeightTwiceIntegrated(a1 + b1) - HeightTwiceIntegrated(a0 + b1) -
           HeightTwiceIntegrated(a1 + b0) + HeightTwiceIntegrated(a0 + b0);
}

/// One texel's interval in [-1, 1] as its parts on either side of 0, both measured from 0.
struct Halves {
    std::array<std::array<double, 2>, 2> part;
    Halves(int i, int n) {
        const double lo = 2. * i / n - 1, hi = 2. * (i + 1) / n - 1;
        part = {{{std::max(0., -hi), std::max(0., -lo)}, {std::max(0., lo), std::max(0., hi)}}};
    }
};

/// Why the image cannot light a scene; empty where it can.
std::string Unfit(const Image &image) {
    const Point2i res = image.Resolution();
    if (res.x != res.y)
        return fmt::format(
            "is {} x {} pixels; an infinite light needs a square picture in the equal-area "
            "octahedral layout: \"imgtool makeequiarea\" makes one of a latitude-longitude picture",
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

std::optional<ImageInfiniteLight> ImageInfiniteLight::Create(ParamDict &params,
                                                             const Transform &renderFromLight) {
    const std::string file = params.GetFileName(kFileName);
    const EmissionScale scale = GetScale(params, kLightIlluminance);
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

float ImageInfiniteLight::Illuminance(const Image &image, const RGBColorSpace &colorSpace) {
    // With u, v in [-1, 1], height is 1 - (|u| + |v|)^2 and solid angle pi du dv (equal_area.h), so
    // that texels, of which the horizon cuts some, are integrated in closed form.
    const Point2i res = image.Resolution();
    double sum = 0;
    for (int y = 0; y < res.y; ++y) {
        const Halves v(y, res.y);
        for (int x = 0; x < res.x; ++x) {
            const Halves u(x, res.x);
            double height = 0;
            for (const auto &[a0, a1] : u.part)
                for (const auto &[b0, b1] : v.part)
                    height += HeightOver(a0, a1, b0, b1);
            sum += height * double(Luminance(TexelRGB(image, x, y), colorSpace));
        }
    }
    return float(sum * double(Pi));
}

uint64_t ImageInfiniteLight::BytesToCreate(const Image &image) {
    const uint64_t n = uint64_t(image.Resolution().x) * uint64_t(image.Resolution().y);
    // Weights, and in the table densities, cumulated values and what they are made from.
    return n * (sizeof(Texel) + 4 * sizeof(float));
}

ImageInfiniteLight ImageInfiniteLight::FromImage(const Image &image,
                                                 const RGBColorSpace &colorSpace, float scale,
                                                 const Transform &renderFromLight) {
    auto sky = std::make_shared<Sky>();
    sky->renderFromLight = renderFromLight;
    sky->lightFromRender = renderFromLight.Inverse();
    sky->invDet = 1 / AbsDeterminant(renderFromLight);
    sky->resolution = image.Resolution().x;
    const Spectrum &white = colorSpace.Illuminant();
    sky->illuminant = white.Densely().Scaled(1 / SpectrumToPhotometric(white));

    const size_t n = size_t(sky->resolution) * size_t(sky->resolution);
    sky->texels.reserve(n);
    std::vector<float> weights;
    weights.reserve(n);
    double luminance = 0;
    for (int y = 0; y < sky->resolution; ++y) {
        for (int x = 0; x < sky->resolution; ++x) {
            const RGB rgb = TexelRGB(image, x, y);
            // Twice the largest component, so that the sigmoid stays away from its ends.
            const float m = 2 * rgb.Max();
            const RGBSigmoid sigmoid =
                m > 0 ? colorSpace.LookUpSigmoid(rgb * (1 / m)) : RGBSigmoid{};
            sky->texels.push_back({sigmoid, m * scale});
            weights.push_back(rgb.Average());
            luminance += double(Luminance(rgb, colorSpace));
        }
    }
    sky->meanLuminance = float(luminance / double(n)) * scale;
    sky->directions = Compensated(std::move(weights), sky->resolution);
    ImageInfiniteLight light;
    light.sky = std::move(sky);
    return light;
}

}  // namespace pbrt
