#pragma once

namespace pbrt {

/// Counts a sampler's draws and says when the next sixteen dimensions' numbers are due: made
/// together they vectorise and their latencies overlap.
class DimensionBlock {
  public:
    static constexpr int kSize = 16;

    void StartAt(int dimension) { next = end = dimension; }
    /// Place of the next draw in its block; calls fill(first dimension) where a new block starts.
    template <typename Fill>
    int Next(Fill fill) {
        if (next == end) {
            const int first = next / kSize * kSize;
            fill(first);
            end = first + kSize;
        }
        return next++ % kSize;
    }

  private:
    int next = 0, end = 0;
};

}  // namespace pbrt
