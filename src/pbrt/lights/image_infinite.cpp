#include "pbrt/lights/image_infinite.h"

#include <numeric>

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

}  // namespace

float ImageInfiniteLight::Illuminance(const Image &image, const RGBColorSpace &colorSpace) {
    const Point2i res = image.Resolution();
    double sum = 0;
    for (int y = 0; y < res.y; ++y) {
        for (int x = 0; x < res.x; ++x) {
            const Vector3f w = EqualAreaSquareToSphere(
                Point2f{(float(x) + 0.5f) / float(res.x), (float(y) + 0.5f) / float(res.y)});
            if (w.z > 0) sum += double(w.z * Luminance(TexelRGB(image, x, y), colorSpace));
        }
    }
    return float(sum * 4 * double(Pi) / (double(res.x) * double(res.y)));
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
