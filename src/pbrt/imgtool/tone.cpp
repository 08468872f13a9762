#include "pbrt/imgtool/tone.h"

#include <algorithm>

namespace pbrt::imgtool {
namespace {

/// Multiplies each pixel but its A by factor(pixel).
template <typename F>
void ScalePixels(Image *image, F factor) {
    const int n = image->NChannels(), alpha = image->ChannelIndex("A");
    for (size_t i = 0; i < image->Data().size(); i += n) {
        float *p = &image->Data()[i];
        const float f = factor(p, n, alpha);
        for (int c = 0; c < n; ++c)
            if (c != alpha) p[c] *= f;
    }
}

/// The image whose pixel p is `image`'s source(p).
template <typename F>
Image Rearranged(const Image &image, Point2i resolution, F source) {
    Image result(resolution, image.ChannelNames());
    result.metadata = image.metadata;
    for (int y = 0; y < resolution.y; ++y)
        for (int x = 0; x < resolution.x; ++x)
            for (int c = 0; c < image.NChannels(); ++c)
                result.Set({x, y}, c, image.Get(source(Point2i{x, y}), c));
    return result;
}

float MedianAbout(const Image &image, Point2i p, int channel) {
    float values[9];
    int n = 0;
    for (int y = std::max(0, p.y - 1); y <= std::min(image.Resolution().y - 1, p.y + 1); ++y)
        for (int x = std::max(0, p.x - 1); x <= std::min(image.Resolution().x - 1, p.x + 1); ++x)
            values[n++] = image.Get({x, y}, channel);
    std::nth_element(values, values + n / 2, values + n);
    return values[n / 2];
}

}  // namespace

float MeanValue(const float *p, int n, int alpha) {
    float sum = 0;
    for (int c = 0; c < n; ++c)
        if (c != alpha) sum += p[c];
    return sum / float(alpha < 0 ? n : std::max(1, n - 1));
}

Image Gray(const Image &image) {
    const int n = image.NChannels(), alpha = image.ChannelIndex("A");
    Image gray(image.Resolution(),
               alpha < 0 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"Y", "A"});
    gray.metadata = image.metadata;
    for (int y = 0; y < image.Resolution().y; ++y)
        for (int x = 0; x < image.Resolution().x; ++x) {
            gray.Set({x, y}, 0, MeanValue(image.Pixel({x, y}), n, alpha));
            if (alpha >= 0) gray.Set({x, y}, 1, image.Get({x, y}, alpha));
        }
    return gray;
}

Image Despike(const Image &image, float threshold) {
    const int n = image.NChannels(), alpha = image.ChannelIndex("A");
    Image result = image;
    for (int y = 0; y < image.Resolution().y; ++y)
        for (int x = 0; x < image.Resolution().x; ++x) {
            if (MeanValue(image.Pixel({x, y}), n, alpha) <= threshold) continue;
            for (int c = 0; c < n; ++c)
                if (c != alpha) result.Set({x, y}, c, MedianAbout(image, {x, y}, c));
        }
    return result;
}

void Reinhard(Image *image, float white) {
    ScalePixels(image, [white](const float *p, int n, int alpha) {
        const float mean = std::max(0.f, MeanValue(p, n, alpha));
        return (1 + mean / (white * white)) / (1 + mean);
    });
}

void ScaleIntoGamut(Image *image) {
    ScalePixels(image, [](const float *p, int n, int alpha) {
        float largest = 1;
        for (int c = 0; c < n; ++c)
            if (c != alpha) largest = std::max(largest, p[c]);
        return 1 / largest;
    });
}

float AcesFilmic(float v) {
    const float x = std::max(0.f, v);
    return std::clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.f, 1.f);
}

Image RepeatPixels(const Image &image, int n) {
    const Point2i size = image.Resolution();
    Image result = Rearranged(image, {n * size.x, n * size.y}, [n](Point2i p) {
        return Point2i{p.x / n, p.y / n};
    });
    for (int &bound : result.metadata.pixelBounds)
        bound *= n;
    result.metadata.fullResolution = n * result.metadata.fullResolution;
    return result;
}

Image FlipY(const Image &image) {
    const int height = image.Resolution().y;
    return Rearranged(image, image.Resolution(), [height](Point2i p) {
        return Point2i{p.x, height - 1 - p.y};
    });
}

}  // namespace pbrt::imgtool
