#include "pbrt/lights/image_infinite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "pbrt/textures/image_color_space.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

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

}  // namespace

std::optional<SkyPicture> ReadSkyPicture(ParamDict &params) {
    const EmissionScale scale = GetScale(params, kLightIlluminance);
    if (params.GetOneSpectrum(kLightRadiance))
        params.Error(kLightRadiance.name,
                     "both \"L\" and \"filename\" are given; an infinite light takes one");
    const StringParam &row = ImageInfiniteLight::kFileName;
    std::optional<Image> image =
        ReadLightPicture(params, row, {.what = "an infinite light", .square = true});
    if (!image) return std::nullopt;
    if (const auto why = WhyTooLarge(ImageInfiniteLight::BytesToCreate(*image))) {
        params.Error(row.name, fmt::format("\"{}\" as a light {}", params.GetFileName(row), *why));
        return std::nullopt;
    }
    const RGBColorSpace &space = ColorSpaceOf(*image);
    const float illuminance = ImageInfiniteLight::Illuminance(*image, space);
    if (scale.target > 0 && !(illuminance > 0)) {
        params.Error(kLightIlluminance.name,
                     "the picture is black above the horizon: no scale can give it "
                     "an illuminance");
        return std::nullopt;
    }
    return SkyPicture{*std::move(image), &space, scale.For(illuminance)};
}

std::optional<ImageInfiniteLight> ImageInfiniteLight::Create(ParamDict &params,
                                                             const Transform &renderFromLight) {
    const std::optional<SkyPicture> sky = ReadSkyPicture(params);
    if (!sky) return std::nullopt;
    return FromImage(sky->image, *sky->space, sky->scale, renderFromLight);
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
    return LightPicture::BytesToCreate(image) + n * 4 * sizeof(float);
}

ImageInfiniteLight ImageInfiniteLight::FromImage(const Image &image,
                                                 const RGBColorSpace &colorSpace, float scale,
                                                 const Transform &renderFromLight) {
    auto sky = std::make_shared<Sky>();
    sky->renderFromLight = renderFromLight;
    sky->lightFromRender = renderFromLight.Inverse();
    sky->invDet = 1 / AbsDeterminant(renderFromLight);
    sky->picture = LightPicture(image, colorSpace, scale);
    const int n = image.Resolution().x;
    std::vector<float> weights;
    weights.reserve(size_t(n) * size_t(n));
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            weights.push_back(TexelRGB(image, x, y).Average());
    sky->directions = Compensated(std::move(weights), n);
    ImageInfiniteLight light;
    light.sky = std::move(sky);
    return light;
}

}  // namespace pbrt
