#include "pbrt/image/image.h"

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
