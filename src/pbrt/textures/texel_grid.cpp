#include "pbrt/textures/texel_grid.h"

#include <algorithm>
#include <array>

namespace pbrt {
namespace {

/// Up to three source texels under one of half the resolution, with their shares.
struct Taps {
    int first;
    std::array<float, 3> weight;
};

std::vector<Taps> HalvingTaps(int from, int to) {
    std::vector<Taps> taps;
    taps.reserve(size_t(to));
    const double step = double(from) / to;
    for (int i = 0; i < to; ++i) {
        const double lo = i * step, hi = (i + 1) * step;
        Taps t{std::min(int(lo), from - 1), {}};
        for (int k = 0; k < 3; ++k) {
            const double left = std::max(lo, double(t.first + k));
            const double right = std::min(hi, double(t.first + k + 1));
            t.weight[size_t(k)] = float(std::max(0.0, right - left) / step);
        }
        taps.push_back(t);
    }
    return taps;
}

}  // namespace

bool TexelGrid::Compress(const ColorEncoding &encoding) {
    constexpr int kBuckets = 4096;
    std::array<float, 256> table;
    for (int k = 0; k < 256; ++k)
        table[size_t(k)] = encoding.ToLinear(float(k) / 255);
    // start[b]: first entry that a value of bucket b can equal.
    std::array<uint8_t, kBuckets + 1> start;
    for (int b = 0, k = 0; b <= kBuckets; ++b) {
        while (k < 255 && table[size_t(k)] * kBuckets < float(b) * (1 - 1e-5f))
            ++k;
        start[size_t(b)] = uint8_t(k);
    }
    std::vector<uint8_t> packed(floats.size());
    for (size_t i = 0; i < floats.size(); ++i) {
        const float v = floats[i], slack = v * 1e-6f;
        if (!(v >= 0 && v <= 1)) return false;
        int k = start[size_t(v * kBuckets)];
        while (k < 255 && table[size_t(k)] < v - slack)
            ++k;
        if (std::abs(table[size_t(k)] - v) > slack) return false;
        packed[i] = uint8_t(k);
    }
    bytes = std::move(packed);
    decoded.assign(table.begin(), table.end());
    floats = {};
    return true;
}

TexelGrid TexelGrid::HalfSize() const {
    const Point2i to{std::max(1, resolution.x / 2), std::max(1, resolution.y / 2)};
    const std::vector<Taps> columns = HalvingTaps(resolution.x, to.x);
    const std::vector<Taps> rows = HalvingTaps(resolution.y, to.y);
    const size_t nc = size_t(nChannels);
    std::vector<float> half(size_t(to.x) * size_t(to.y) * nc);
    for (int y = 0; y < to.y; ++y) {
        for (int x = 0; x < to.x; ++x) {
            const Taps &column = columns[size_t(x)], &row = rows[size_t(y)];
            float *out = &half[(size_t(y) * size_t(to.x) + size_t(x)) * nc];
            for (size_t ky = 0; ky < 3; ++ky) {
                for (size_t kx = 0; kx < 3; ++kx) {
                    const float w = row.weight[ky] * column.weight[kx];
                    if (w == 0) continue;
                    const size_t from =
                        (size_t(row.first) + ky) * size_t(resolution.x) + size_t(column.first) + kx;
                    for (size_t c = 0; c < nc; ++c)
                        out[c] += w * Value(from * nc + c);
                }
            }
        }
    }
    return TexelGrid(to, nChannels, std::move(half));
}

}  // namespace pbrt
