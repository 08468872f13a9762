#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pbrt/textures/texel_grid.h"

namespace pbrt {

enum class TextureFilter { Point, Bilinear, Trilinear, EWA };
/// Rule for look-ups outside [0, 1]^2.
enum class WrapMode { Repeat, Black, Clamp };

struct TextureSampling {
    TextureFilter filter = TextureFilter::Bilinear;
    WrapMode wrap = WrapMode::Repeat;
    float maxAnisotropy = 8;
};

/// Two footprint axes in (s, t) per pixel step.
struct Footprint {
    float dsdx = 0, dtdx = 0, dsdy = 0, dtdy = 0;
};

/// A texture's image and its halvings down to one texel, which take 4/3 bytes for a byte of an
/// 8-bit image and 1/3 for one of others. Immutable.
/// (0, 0) is the upper left corner of the upper left texel, (1, 1) the lower right.
class MIPMap {
  public:
    /// Takes R, G, B, or Y, or the only channel; nullptr where the image has none of these.
    /// `encoding`: the one that the file's bytes had, for compact storage.
    static std::shared_ptr<const MIPMap> Create(const Image &image, const ColorEncoding &encoding);
    /// Takes the channel A, which the image must have.
    static std::shared_ptr<const MIPMap> CreateOfAlpha(const Image &image);
    /// Has channels R, G, B, and A that is not 1 everywhere: pbrt-v4 reads floats from A then.
    static bool HasAlpha(const Image &image);

    /// The most memory that Create takes, beside the image: all levels as floats.
    static uint64_t BytesToCreate(const Image &image);

    /// Filtered value, T = float (mean of the channels) or RGB. Point and bilinear look at one
    /// level, trilinear between two, by pbrt-v4's rule: the number of levels - 1 + log2 of twice
    /// the largest component of the footprint, rounded down where one level is wanted. EWA:
    /// elliptical Gaussian (Heckbert 1989) whose axes are the footprint's, long axis at most
    /// maxAnisotropy times the short one. Without footprint all look at the finest level.
    template <typename T>
    T Lookup(Point2f st, const Footprint &footprint, const TextureSampling &sampling) const;

    int NChannels() const { return levels[0].NChannels(); }
    int NLevels() const { return int(levels.size()); }
    const TexelGrid &Level(int i) const { return levels[size_t(i)]; }
    /// Color space of the image's primaries where these are a known space's, else sRGB.
    const RGBColorSpace &ColorSpace() const { return *colorSpace; }
    /// True where the image HasAlpha, and this is its colour.
    bool LeavesOutAlpha() const { return leavesOutAlpha; }
    size_t MemoryBytes() const;

  private:
    static std::shared_ptr<MIPMap> Of(const Image &image, const std::vector<int> &channels,
                                      const ColorEncoding &encoding);
    template <typename T>
    T Texel(int level, int x, int y, WrapMode wrap) const;
    template <typename T>
    T Nearest(int level, Point2f st, WrapMode wrap) const;
    template <typename T>
    T Bilinear(int level, Point2f st, WrapMode wrap) const;
    template <typename T>
    T Trilinear(Point2f st, const Footprint &footprint, WrapMode wrap) const;
    template <typename T>
    T Elliptical(Point2f st, const Footprint &footprint, const TextureSampling &sampling) const;
    template <typename T>
    T EllipseMean(int level, Point2f st, const Footprint &footprint, WrapMode wrap) const;

    /// The whole part of the level that Lookup speaks of.
    int LevelFor(const Footprint &f) const;

    std::vector<TexelGrid> levels;
    bool leavesOutAlpha = false;
    const RGBColorSpace *colorSpace = &RGBColorSpace::sRGB();
};

}  // namespace pbrt
