#pragma once

#include <span>
#include <vector>

#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// A number for each pixel of a batch.
class PixelTable {
  public:
    /// Pixels are counted up to the next multiple of sixteen.
    void Resize(size_t pixels) {
        values.resize((pixels + kPacketSize - 1) / kPacketSize * kPacketSize);
    }
    /// valueOf(pixel) for each.
    template <typename F>
    void Fill(std::span<const Point2i> pixels, const F &valueOf) {
        Resize(pixels.size());
        for (size_t i = 0; i < pixels.size(); ++i)
            values[i] = valueOf(pixels[i]);
    }
    size_t Size() const { return values.size(); }
    uint32_t &operator[](size_t pixel) { return values[pixel]; }
    /// Values of the sixteen pixels from `first` on.
    UintX16 From(size_t first) const { return LoadX16(&values[first]); }
    void SetFrom(size_t first, UintX16 v) { Store(v, &values[first]); }
    /// Value of pixel[lane] in each lane.
    UintX16 At(UintX16 pixel) const {
        return values.size() == kPacketSize ? Permute(From(0), pixel)
                                            : Gather(values.data(), pixel);
    }

  private:
    std::vector<uint32_t> values;
};

/// 64 bits for each pixel of a batch: Hash(seed, pixel).
class PixelHashes {
  public:
    void Start(std::span<const Point2i> pixels, int seed) {
        low.Resize(pixels.size());
        high.Resize(pixels.size());
        for (size_t i = 0; i < pixels.size(); ++i) {
            const uint64_t bits = Hash(seed, pixels[i]);
            low[i] = uint32_t(bits);
            high[i] = uint32_t(bits >> 32);
        }
    }
    Uint64X16 At(UintX16 pixel) const { return Join(low.At(pixel), high.At(pixel)); }

  private:
    PixelTable low, high;
};

}  // namespace pbrt
