#include <algorithm>
#include <array>

#include "pbrt/image/codecs.h"
#include "pbrt/image/primaries.h"

namespace pbrt {
namespace {

/// Indices of channels: one or three of values, and alpha or -1.
struct Picked {
    std::vector<int> values;
    int alpha = -1;
};

/// "R" of "Albedo.R".
std::string_view LastPart(std::string_view name) {
    return name.substr(name.rfind('.') + 1);
}

/// A, else A of a layer if there is but one; else -1.
int AlphaOf(const Image &image) {
    const int exact = image.ChannelIndex("A");
    if (exact >= 0) return exact;
    int found = -1;
    for (int c = 0; c < image.NChannels(); ++c) {
        if (LastPart(image.ChannelNames()[c]) != "A") continue;
        if (found >= 0) return -1;
        found = c;
    }
    return found;
}

/// No values where the image has none that can be told from the rest.
Picked PickChannels(const Image &image) {
    const int r = image.ChannelIndex("R"), g = image.ChannelIndex("G"), b = image.ChannelIndex("B");
    if (r >= 0 && g >= 0 && b >= 0) return {{r, g, b}, image.ChannelIndex("A")};
    if (image.NChannels() == 1) return {{0}};
    const int y = image.ChannelIndex("Y");
    const bool isXYZ = image.ChannelIndex("X") >= 0;
    if (y >= 0 && !isXYZ) return {{y}, image.ChannelIndex("A")};
    Picked picked{{}, AlphaOf(image)};
    for (int c = 0; c < image.NChannels(); ++c)
        if (c != picked.alpha) picked.values.push_back(c);
    if (picked.values.size() == 1 || picked.values.size() == 3) return picked;
    return {};
}

bool AreColors(const Image &image, const std::vector<int> &values) {
    constexpr std::array<std::string_view, 3> kNames{"R", "G", "B"};
    return std::equal(
        values.begin(), values.end(), kNames.begin(), kNames.end(),
        [&](int c, std::string_view name) { return LastPart(image.ChannelNames()[c]) == name; });
}

}  // namespace

OrError<Image> ForDisplay(const Image &image, bool withAlpha) {
    const Picked picked = PickChannels(image);
    if (picked.values.empty())
        return {{},
                "needs the channels R, G and B, or Y, or one or three beside alpha in this format"};
    const bool isGray = picked.values.size() == 1;
    std::vector<int> source = picked.values;
    std::vector<std::string> names =
        isGray ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    if (withAlpha && picked.alpha >= 0) {
        source.push_back(picked.alpha);
        names.push_back("A");
    }
    const bool converts = image.metadata.chromaticities && AreColors(image, picked.values);
    const auto toSRGB = RGBFromRGB(kSRGBChromaticities,
                                   converts ? *image.metadata.chromaticities : kSRGBChromaticities);
    if (!toSRGB) return {{}, "has chromaticities that span no color space"};

    Image display(image.Resolution(), names);
    const size_t n = names.size();
    for (size_t p = 0; p < display.Data().size() / n; ++p) {
        const float *in = &image.Data()[p * image.NChannels()];
        float *out = &display.Data()[p * n];
        for (size_t c = 0; c < n; ++c)
            out[c] = in[source[c]];
        if (!converts) continue;
        const std::array<float, 3> rgb{out[0], out[1], out[2]};
        for (int i = 0; i < 3; ++i)
            out[i] = (*toSRGB)[i][0] * rgb[0] + (*toSRGB)[i][1] * rgb[1] + (*toSRGB)[i][2] * rgb[2];
    }
    return {std::move(display), {}};
}

}  // namespace pbrt
