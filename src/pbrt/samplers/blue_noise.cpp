#include "pbrt/samplers/blue_noise.h"

#include <algorithm>
#include <cmath>

#include "pbrt/util/math.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

constexpr int kSide = BlueNoise::kSide, kPixels = kSide * kSide;

/// Pixels that are set, and at each pixel how crowded its surroundings are: the sum of a Gaussian
/// over the set ones, on the torus.
class Crowd {
  public:
    Crowd() {
        for (int i = 0; i <= 2 * kRadius; ++i)
            weight[size_t(i)] = std::exp(-float((i - kRadius) * (i - kRadius)) / (2 * kVariance));
    }
    bool IsSet(int pixel) const { return set[size_t(pixel)]; }
    void Set(int pixel, bool value) {
        set[size_t(pixel)] = value;
        const int x = pixel % kSide, y = pixel / kSide;
        for (int dy = -kRadius; dy <= kRadius; ++dy) {
            float *row = &density[size_t((y + dy + kSide) % kSide * kSide)];
            const float factor = (value ? 1.f : -1.f) * weight[size_t(dy + kRadius)];
            for (int dx = -kRadius; dx <= kRadius; ++dx)
                row[(x + dx + kSide) % kSide] += factor * weight[size_t(dx + kRadius)];
        }
    }
    /// The pixel in the densest surroundings of those that are set.
    int TightestCluster() const { return Extreme(true, 1); }
    /// The pixel in the emptiest surroundings of those that are not.
    int LargestVoid() const { return Extreme(false, -1); }

  private:
    static constexpr int kRadius = 7;
    static constexpr float kVariance = 1.5f * 1.5f;  // Ulichney's choice, in pixels squared

    int Extreme(bool ofSet, float sign) const {
        int best = -1;
        for (int i = 0; i < kPixels; ++i) {
            if (set[size_t(i)] != ofSet) continue;
            if (best < 0 || sign * density[size_t(i)] > sign * density[size_t(best)]) best = i;
        }
        return best;
    }

    std::array<float, 2 * kRadius + 1> weight;
    std::array<float, kPixels> density{};
    std::array<bool, kPixels> set{};
};

/// A tenth of the pixels, moved from clusters into voids until nothing gets better.
Crowd EvenlySpread() {
    Crowd crowd;
    Rng rng(1);
    for (int count = 0; count < kPixels / 10;) {
        const int pixel = int(rng.Below(kPixels));
        if (crowd.IsSet(pixel)) continue;
        crowd.Set(pixel, true);
        ++count;
    }
    for (int from = -1, to = -2; from != to;) {
        from = crowd.TightestCluster();
        crowd.Set(from, false);
        to = crowd.LargestVoid();
        crowd.Set(to, true);
    }
    return crowd;
}

}  // namespace

const BlueNoise &BlueNoise::Get() {
    static const BlueNoise noise;
    return noise;
}

BlueNoise::BlueNoise() {
    const auto number = [&](int pixel, int rank) {
        reversed[size_t(pixel)] = ReverseBits32(uint32_t(rank) << (32 - kBits));
    };
    const Crowd start = EvenlySpread();
    Crowd crowd = start;
    const int count = kPixels / 10;
    for (int rank = count - 1; rank >= 0; --rank) {
        const int pixel = crowd.TightestCluster();
        crowd.Set(pixel, false);
        number(pixel, rank);
    }
    // Beyond half of the pixels the tightest cluster of what is not set is the same as the largest
    // void, for the Gaussian's sum over all pixels is constant.
    crowd = start;
    for (int rank = count; rank < kPixels; ++rank) {
        const int pixel = crowd.LargestVoid();
        crowd.Set(pixel, true);
        number(pixel, rank);
    }
}

}  // namespace pbrt
