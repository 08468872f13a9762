#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pbrt/textures/texel_grid.h"

namespace pbrt {

enum class TextureFilter { Point, Bilinear, Trilinear, EWA };
/// What stands outside [0, 1]^2.
enum class WrapMode { Repeat, Black, Clamp };

struct TextureSampling {
    TextureFilter filter = TextureFilter::Bilinear;
    WrapMode wrap = WrapMode::Repeat;
    float maxAnisotropy = 8;
    bool NeedsPyramid() const { return filter >= TextureFilter::Trilinear; }
};

/// Two footprint axes in (s, t) per pixel step.
struct Footprint {
    float dsdx = 0, dtdx = 0, dsdy = 0, dtdy = 0;
};

/// A texture's picture and, where asked for, its halvings down to one texel. Immutable.
/// (0, 0) is the upper left corner of the upper left texel, (1, 1) the lower right.
class MIPMap {
  public:
    /// Takes R, G, B, or Y, or the only channel; nullptr where the picture has none of these.
    /// `encoding`: the one that the file's bytes had, for compact storage.
    static std::shared_ptr<const MIPMap> Create(const Image &image, const ColorEncoding &encoding,
                                                bool pyramid);

    /// The most memory that Create takes, beside the picture: all levels as floats.
    static uint64_t BytesToCreate(const Image &image);

    /// Filtered value, T = float (mean of the channels) or RGB. EWA: elliptical Gaussian
    /// (Heckbert 1989) whose axes are the footprint's, long axis at most maxAnisotropy times the
    /// short one; trilinear: by the longer axis. Without footprint both are bilinear.
    template <typename T>
    T Lookup(Point2f st, const Footprint &footprint, const TextureSampling &sampling) const;

    int NChannels() const { return levels[0].NChannels(); }
    int NLevels() const { return int(levels.size()); }
    const TexelGrid &Level(int i) const { return levels[size_t(i)]; }
    /// Of the picture's primaries where these are one of the known spaces', else sRGB.
    const RGBColorSpace &ColorSpace() const { return *colorSpace; }
    size_t MemoryBytes() const;

  private:
    template <typename T>
    T Texel(int level, int x, int y, WrapMode wrap) const;
    template <typename T>
    T Nearest(Point2f st, WrapMode wrap) const;
    template <typename T>
    T Bilinear(int level, Point2f st, WrapMode wrap) const;
    template <typename T>
    T Trilinear(Point2f st, const Footprint &footprint, WrapMode wrap) const;
    template <typename T>
    T Elliptical(Point2f st, const Footprint &footprint, const TextureSampling &sampling) const;
    template <typename T>
    T EllipseMean(int level, Point2f st, const Footprint &footprint, WrapMode wrap) const;

    std::vector<TexelGrid> levels;
    const RGBColorSpace *colorSpace = &RGBColorSpace::sRGB();
};

}  // namespace pbrt
