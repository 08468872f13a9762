#pragma once

#include <array>
#include <cstdint>

namespace pbrt {

/// A square of 64 x 64 pixels, repeated over the image, in which each of the numbers 0 to 4095
/// stands once and numbers near each other far apart: "void and cluster" (Ulichney 1993, "The
/// Void-and-Cluster Method for Dither Array Generation"). Neighbours differ, so that errors that
/// follow the number have few low frequencies. Made once, in some ten milliseconds.
class BlueNoise {
  public:
    static constexpr int kLog2Side = 6, kSide = 1 << kLog2Side, kBits = 2 * kLog2Side;

    static const BlueNoise &Get();

    /// At pixel (i % 64, i / 64): kBits digits, reversed (sobol.h).
    const uint32_t *Reversed() const { return reversed.data(); }

  private:
    BlueNoise();

    alignas(64) std::array<uint32_t, kSide * kSide> reversed;
};

}  // namespace pbrt
