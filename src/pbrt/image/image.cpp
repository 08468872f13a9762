#include "pbrt/image/image.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "pbrt/util/check.h"

namespace pbrt {

Image::Image(Point2i resolution, std::vector<std::string> channels)
    : resolution(resolution), channels(std::move(channels)) {
    DCHECK(resolution.x >= 0 && resolution.y >= 0);
    pixels.resize(Offset({0, resolution.y}));
}

int Image::ChannelIndex(std::string_view name) const {
    const auto found = std::find(channels.begin(), channels.end(), name);
    return found == channels.end() ? -1 : int(found - channels.begin());
}

OrError<Image> SelectChannels(const Image &image, const std::vector<std::string> &names) {
    std::vector<int> source;
    for (const std::string &name : names) {
        source.push_back(image.ChannelIndex(name));
        if (source.back() < 0)
            return {{},
                    fmt::format("has no channel \"{}\", but {}", name,
                                fmt::join(image.ChannelNames(), ", "))};
    }
    Image selected(image.Resolution(), names);
    selected.metadata = image.metadata;
    for (int y = 0; y < image.Resolution().y; ++y)
        for (int x = 0; x < image.Resolution().x; ++x)
            for (size_t c = 0; c < source.size(); ++c)
                selected.Set({x, y}, int(c), image.Get({x, y}, source[c]));
    return {std::move(selected), {}};
}

bool TransformRGB(const Matrix3 &m, Image *image) {
    const std::array<int, 3> index{image->ChannelIndex("R"), image->ChannelIndex("G"),
                                   image->ChannelIndex("B")};
    if (*std::min_element(index.begin(), index.end()) < 0) return false;
    for (size_t i = 0; i < image->Data().size(); i += size_t(image->NChannels())) {
        float *const p = &image->Data()[i];
        const std::array<float, 3> rgb =
            Mul(m, std::array<float, 3>{p[index[0]], p[index[1]], p[index[2]]});
        for (size_t c = 0; c < 3; ++c)
            p[index[c]] = rgb[c];
    }
    return true;
}

float ColorEncoding::ToLinear(float encoded) const {
    switch (kind) {
        case Kind::Linear:
            return encoded;
        case Kind::sRGB:  // IEC 61966-2-1
            return encoded <= 0.04045f ? encoded / 12.92f
                                       : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
        case Kind::Gamma:
            return std::pow(std::max(0.f, encoded), gamma);
    }
    return encoded;
}

float ColorEncoding::FromLinear(float linear) const {
    switch (kind) {
        case Kind::Linear:
            return linear;
        case Kind::sRGB:
            return linear <= 0.0031308f ? linear * 12.92f
                                        : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
        case Kind::Gamma:
            return std::pow(std::max(0.f, linear), 1 / gamma);
    }
    return linear;
}

}  // namespace pbrt
