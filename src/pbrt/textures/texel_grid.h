#pragma once

#include <cstdint>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/spectra/color.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Linear texels of one resolution with one or three channels. Values that all come from a table
/// of 256 (an 8-bit image) are kept as bytes.
class TexelGrid {
  public:
    /// `values`: rows from the top, `nChannels` (1 or 3) per texel.
    TexelGrid(Point2i resolution, int nChannels, std::vector<float> values)
        : resolution(resolution), nChannels(nChannels), floats(std::move(values)) {}
    /// Turns to bytes where every value is within 1e-6 (relative) of one that `encoding` gives for
    /// a byte; else nothing changes and the result is false.
    bool Compress(const ColorEncoding &encoding);

    Point2i Resolution() const { return resolution; }
    int NChannels() const { return nChannels; }
    size_t MemoryBytes() const { return bytes.size() + floats.size() * sizeof(float); }

    /// x, y inside the resolution. float: the mean of the channels.
    template <typename T>
    T Get(int x, int y) const {
        const size_t i = (size_t(y) * size_t(resolution.x) + size_t(x)) * size_t(nChannels);
        if (nChannels == 1) return T(Broadcast{Value(i)});
        return T(Triple{Value(i), Value(i + 1), Value(i + 2)});
    }
    /// Half the size per axis (at least 1) by area-weighted means; the mean of all is kept.
    TexelGrid HalfSize() const;

  private:
    struct Broadcast {
        float v;
        operator float() const { return v; }
        operator RGB() const { return {v, v, v}; }
    };
    struct Triple {
        float r, g, b;
        operator float() const { return (r + g + b) * (1 / 3.f); }
        operator RGB() const { return {r, g, b}; }
    };
    float Value(size_t i) const { return bytes.empty() ? floats[i] : decoded[bytes[i]]; }

    Point2i resolution;
    int nChannels;
    std::vector<float> floats;
    std::vector<uint8_t> bytes;  ///< instead of floats
    std::vector<float> decoded;  ///< of each byte
};

}  // namespace pbrt
