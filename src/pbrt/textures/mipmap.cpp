#include "pbrt/textures/mipmap.h"

#include <algorithm>
#include <cmath>

#include "pbrt/textures/image_color_space.h"

namespace pbrt {
namespace {

float MultiplyAdd(float sum, float w, float v) {
    return sum + w * v;
}
RGB MultiplyAdd(RGB sum, float w, RGB v) {
    return {sum.r + w * v.r, sum.g + w * v.g, sum.b + w * v.b};
}

/// Index inside [0, n), or -1 where the black surround begins.
int Wrap(int i, int n, WrapMode wrap) {
    if (unsigned(i) < unsigned(n)) return i;
    if (wrap == WrapMode::Black) return -1;
    if (wrap == WrapMode::Clamp) return i < 0 ? 0 : n - 1;
    const int r = i % n;
    return r < 0 ? r + n : r;
}

/// A coordinate with the same texel, small enough for int arithmetic; some corner for NaN and what
/// has no place within a period.
float Tame(float s, WrapMode wrap) {
    if (wrap != WrapMode::Repeat) return s > -64 ? std::min(s, 65.f) : -64.f;
    const float within = s - std::floor(s);
    return within >= 0 ? within : 0.f;
}
Point2f Tame(Point2f st, WrapMode wrap) {
    return {Tame(st.x, wrap), Tame(st.y, wrap)};
}

/// Channels that a texture reads; empty where the image has no colour it knows.
std::vector<int> ColorChannels(const Image &image) {
    const int r = image.ChannelIndex("R"), g = image.ChannelIndex("G"), b = image.ChannelIndex("B");
    if (r >= 0 && g >= 0 && b >= 0) return {r, g, b};
    const int y = image.ChannelIndex("Y");
    if (y >= 0) return {y};
    if (image.NChannels() == 1) return {0};
    return {};
}

/// Twice the largest component, as pbrt-v4 measures footprints.
float Width(const Footprint &f) {
    return 2 * std::max({std::abs(f.dsdx), std::abs(f.dtdx), std::abs(f.dsdy), std::abs(f.dtdy)});
}

}  // namespace

std::shared_ptr<const MIPMap> MIPMap::Create(const Image &image, const ColorEncoding &encoding) {
    const std::vector<int> channels = ColorChannels(image);
    const Point2i res = image.Resolution();
    if (channels.empty() || res.x < 1 || res.y < 1) return nullptr;
    std::shared_ptr<MIPMap> map = Of(image, channels, encoding);
    map->leavesOutAlpha = HasAlpha(image);
    return map;
}

bool MIPMap::HasAlpha(const Image &image) {
    const int a = image.ChannelIndex("A");
    if (a < 0 || ColorChannels(image).size() != 3) return false;
    for (size_t i = size_t(a); i < image.Data().size(); i += size_t(image.NChannels()))
        if (image.Data()[i] != 1) return true;
    return false;
}

std::shared_ptr<const MIPMap> MIPMap::CreateOfAlpha(const Image &image) {
    return Of(image, {image.ChannelIndex("A")}, ColorEncoding{});
}

std::shared_ptr<MIPMap> MIPMap::Of(const Image &image, const std::vector<int> &channels,
                                   const ColorEncoding &encoding) {
    const Point2i res = image.Resolution();
    std::vector<float> values;
    values.reserve(size_t(res.x) * size_t(res.y) * channels.size());
    for (int y = 0; y < res.y; ++y)
        for (int x = 0; x < res.x; ++x)
            for (int c : channels)
                values.push_back(image.Get({x, y}, c));

    auto map = std::make_shared<MIPMap>();
    map->colorSpace = &ColorSpaceOf(image);
    map->levels.emplace_back(res, int(channels.size()), std::move(values));
    if (image.metadata.storedAs == "8-bit") map->levels[0].Compress(encoding);
    while (map->levels.back().Resolution() != Point2i{1, 1})
        map->levels.push_back(map->levels.back().HalfSize());
    return map;
}

uint64_t MIPMap::BytesToCreate(const Image &image) {
    const Point2i res = image.Resolution();
    const uint64_t values = uint64_t(res.x) * uint64_t(res.y) * ColorChannels(image).size();
    return values * sizeof(float) * 4 / 3;
}

size_t MIPMap::MemoryBytes() const {
    size_t sum = 0;
    for (const TexelGrid &level : levels)
        sum += level.MemoryBytes();
    return sum;
}

template <typename T>
T MIPMap::Texel(int level, int x, int y, WrapMode wrap) const {
    const TexelGrid &grid = levels[size_t(level)];
    x = Wrap(x, grid.Resolution().x, wrap), y = Wrap(y, grid.Resolution().y, wrap);
    return x < 0 || y < 0 ? T{} : grid.Get<T>(x, y);
}

template <typename T>
T MIPMap::Nearest(int level, Point2f st, WrapMode wrap) const {
    const Point2i res = levels[size_t(level)].Resolution();
    st = Tame(st, wrap);
    return Texel<T>(level, int(std::floor(st.x * float(res.x))),
                    int(std::floor(st.y * float(res.y))), wrap);
}

int MIPMap::LevelFor(const Footprint &f) const {
    constexpr float kBelowAllLevels = 0x1p-31f;
    const float width = std::min(Width(f), 1.f);
    if (!(width > kBelowAllLevels)) return 0;
    return std::max(0, NLevels() - 1 + std::ilogb(width));
}

template <typename T>
T MIPMap::Bilinear(int level, Point2f st, WrapMode wrap) const {
    const Point2i res = levels[size_t(level)].Resolution();
    st = Tame(st, wrap);
    const float x = st.x * float(res.x) - 0.5f, y = st.y * float(res.y) - 0.5f;
    const float x0 = std::floor(x), y0 = std::floor(y);
    const float dx = x - x0, dy = y - y0;
    const int xi = int(x0), yi = int(y0);
    T sum = MultiplyAdd(T{}, (1 - dx) * (1 - dy), Texel<T>(level, xi, yi, wrap));
    sum = MultiplyAdd(sum, dx * (1 - dy), Texel<T>(level, xi + 1, yi, wrap));
    sum = MultiplyAdd(sum, (1 - dx) * dy, Texel<T>(level, xi, yi + 1, wrap));
    return MultiplyAdd(sum, dx * dy, Texel<T>(level, xi + 1, yi + 1, wrap));
}

template <typename T>
T MIPMap::Trilinear(Point2f st, const Footprint &f, WrapMode wrap) const {
    const int last = NLevels() - 1;
    const float lod = float(last) + std::log2(Width(f));
    if (!(lod > 0)) return Bilinear<T>(0, st, wrap);
    if (lod >= float(last)) return Bilinear<T>(last, st, wrap);
    const int level = int(lod);
    const float part = lod - float(level);
    const T fine = MultiplyAdd(T{}, 1 - part, Bilinear<T>(level, st, wrap));
    return MultiplyAdd(fine, part, Bilinear<T>(level + 1, st, wrap));
}

template <typename T>
T MIPMap::Elliptical(Point2f st, const Footprint &f, const TextureSampling &sampling) const {
    const Point2i res = levels[0].Resolution();
    const float w = float(res.x), h = float(res.y);
    const float x2 = Sqr(f.dsdx * w) + Sqr(f.dtdx * h), y2 = Sqr(f.dsdy * w) + Sqr(f.dtdy * h);
    const bool xIsLong = x2 >= y2;
    const float longest = std::sqrt(std::max(x2, y2)), shortest = std::sqrt(std::min(x2, y2));
    if (!(longest > 0)) return Bilinear<T>(0, st, sampling.wrap);
    const int last = NLevels() - 1;
    if (!(x2 + y2 < Infinity)) return Bilinear<T>(last, st, sampling.wrap);
    const float wanted = longest / std::max(1.f, sampling.maxAnisotropy);
    Footprint g = f;
    if (shortest < wanted) {
        // Too thin: the short axis becomes a vector of length `wanted` across the long one.
        const float a = (xIsLong ? f.dsdx : f.dsdy) * w, b = (xIsLong ? f.dtdx : f.dtdy) * h;
        const float k = wanted / longest;
        (xIsLong ? g.dsdy : g.dsdx) = -b * k / w;
        (xIsLong ? g.dtdy : g.dtdx) = a * k / h;
    }
    const float width = std::max(shortest, wanted);
    if (!(width > 1)) return EllipseMean<T>(0, st, g, sampling.wrap);
    const float lod = std::log2(width);
    if (lod >= float(last)) return Bilinear<T>(last, st, sampling.wrap);
    const int level = int(lod);
    const float part = lod - float(level);
    const T fine = MultiplyAdd(T{}, 1 - part, EllipseMean<T>(level, st, g, sampling.wrap));
    return MultiplyAdd(fine, part, EllipseMean<T>(level + 1, st, g, sampling.wrap));
}

template <typename T>
T MIPMap::EllipseMean(int level, Point2f st, const Footprint &f, WrapMode wrap) const {
    const Point2i res = levels[size_t(level)].Resolution();
    st = Tame(st, wrap);
    const float cx = st.x * float(res.x) - 0.5f, cy = st.y * float(res.y) - 0.5f;
    const float xs = f.dsdx * float(res.x), xt = f.dtdx * float(res.y);
    const float ys = f.dsdy * float(res.x), yt = f.dtdy * float(res.y);
    // Covariance-like matrix of the footprint plus the texel's own unit width; its inverse gives
    // the squared radius of an offset, 1 on the ellipse.
    const float m00 = Sqr(xs) + Sqr(ys) + 1, m11 = Sqr(xt) + Sqr(yt) + 1, m01 = xs * xt + ys * yt;
    const float invDet = 1 / (m00 * m11 - Sqr(m01));
    const float q00 = m11 * invDet, q11 = m00 * invDet, q01 = -2 * m01 * invDet;
    // The ellipse's extent along the axes is the root of the diagonal.
    const float rx = std::sqrt(m00), ry = std::sqrt(m11);
    const int x0 = int(std::ceil(cx - rx)), x1 = int(std::floor(cx + rx));
    const int y0 = int(std::ceil(cy - ry)), y1 = int(std::floor(cy + ry));
    constexpr float kSharpness = 2;
    const float edge = std::exp(-kSharpness);
    T sum{};
    float weights = 0;
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const float dx = float(x) - cx, dy = float(y) - cy;
            const float r2 = q00 * Sqr(dx) + q01 * dx * dy + q11 * Sqr(dy);
            if (r2 >= 1) continue;
            const float weight = std::exp(-kSharpness * r2) - edge;
            sum = MultiplyAdd(sum, weight, Texel<T>(level, x, y, wrap));
            weights += weight;
        }
    }
    // A unit circle about any point holds a texel's centre, so there is always one.
    return MultiplyAdd(T{}, 1 / weights, sum);
}

template <typename T>
T MIPMap::Lookup(Point2f st, const Footprint &footprint, const TextureSampling &sampling) const {
    switch (sampling.filter) {
        case TextureFilter::Point:
            return Nearest<T>(LevelFor(footprint), st, sampling.wrap);
        case TextureFilter::Bilinear:
            return Bilinear<T>(LevelFor(footprint), st, sampling.wrap);
        case TextureFilter::Trilinear:
            return Trilinear<T>(st, footprint, sampling.wrap);
        case TextureFilter::EWA:
            return Elliptical<T>(st, footprint, sampling);
    }
    return T{};
}

template float MIPMap::Lookup(Point2f, const Footprint &, const TextureSampling &) const;
template RGB MIPMap::Lookup(Point2f, const Footprint &, const TextureSampling &) const;

}  // namespace pbrt
