#include "pbrt/textures/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "pbrt/util/math.h"

namespace pbrt {
namespace {

/// Permutation of 0 to 255 that gives each lattice point its gradient; a fact of Perlin 2002.
constexpr std::array<uint8_t, 256> kPermutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180,
};

/// One axis: the lattice cell, and the place in it from 0 to 1.
struct Cell {
    explicit Cell(float x) {
        if (!(std::abs(x) < 0x1p24f)) return;
        const float whole = std::floor(x);
        at = unsigned(int(whole)) & 255;
        offset = x - whole;
    }
    /// The share of the upper end: Perlin's quintic, with no slope nor curvature at either end.
    float Weight() const { return offset * offset * offset * (10 + offset * (6 * offset - 15)); }
    unsigned at = 0;
    float offset = 0;
};

/// (x, y, z) times the lattice point's gradient, which is one of the twelve from a cube's middle to
/// its edges; four of them stand twice among the sixteen.
float Gradient(unsigned ix, unsigned iy, unsigned iz, float x, float y, float z) {
    const auto permuted = [](unsigned i) -> unsigned { return kPermutation[i & 255]; };
    const unsigned h = permuted(permuted(permuted(ix) + iy) + iz) & 15;
    const float u = h < 8 || h == 12 || h == 13 ? x : y;
    const float v = h < 4 || h == 12 || h == 13 ? y : z;
    return ((h & 1) != 0 ? -u : u) + ((h & 2) != 0 ? -v : v);
}

/// How far an octave is faded in: a cubic step from 0.3 to 0.7.
float FadedIn(float part) {
    const float x = std::clamp((part - 0.3f) / 0.4f, 0.f, 1.f);
    return x * x * (3 - 2 * x);
}

/// Octaves whose waves are twice as long as a pixel's longer step, at least.
float ShownOctaves(Vector3f dpdx, Vector3f dpdy, int octaves) {
    const float step2 = std::max(LengthSquared(dpdx), LengthSquared(dpdy));
    if (!(step2 > 0)) return float(octaves);  // no steps, or none that are numbers
    return std::clamp(-1 - 0.5f * std::log2(step2), 0.f, float(octaves));
}

constexpr float kLacunarity = 1.99f;

Point3f Times(float factor, Point3f p) {
    return {factor * p.x, factor * p.y, factor * p.z};
}

}  // namespace

float Noise(Point3f p) {
    const Cell x(p.x), y(p.y), z(p.z);
    const auto gradient = [&](unsigned dx, unsigned dy, unsigned dz) {
        return Gradient(x.at + dx, y.at + dy, z.at + dz, x.offset - float(dx), y.offset - float(dy),
                        z.offset - float(dz));
    };
    const auto alongX = [&](unsigned dy, unsigned dz) {
        return Lerp(x.Weight(), gradient(0, dy, dz), gradient(1, dy, dz));
    };
    const auto alongXY = [&](unsigned dz) {
        return Lerp(y.Weight(), alongX(0, dz), alongX(1, dz));
    };
    return Lerp(z.Weight(), alongXY(0), alongXY(1));
}

float FBm(Point3f p, Vector3f dpdx, Vector3f dpdy, float roughness, int octaves) {
    const float shown = ShownOctaves(dpdx, dpdy, octaves);
    float sum = 0, frequency = 1, height = 1;
    for (int i = 0; i < int(shown); ++i) {
        sum += height * Noise(Times(frequency, p));
        frequency *= kLacunarity;
        height *= roughness;
    }
    return sum + height * FadedIn(shown - std::floor(shown)) * Noise(Times(frequency, p));
}

float Turbulence(Point3f p, Vector3f dpdx, Vector3f dpdy, float roughness, int octaves) {
    constexpr float kMean = 0.2f;  // of the noise's absolute value
    const float shown = ShownOctaves(dpdx, dpdy, octaves);
    const int whole = int(shown);
    float sum = 0, frequency = 1, height = 1;
    for (int i = 0; i < whole; ++i) {
        sum += height * std::abs(Noise(Times(frequency, p)));
        frequency *= kLacunarity;
        height *= roughness;
    }
    const float last = std::abs(Noise(Times(frequency, p)));
    sum += height * Lerp(FadedIn(shown - float(whole)), kMean, last);
    for (int i = whole; i < octaves; ++i) {
        sum += height * kMean;
        height *= roughness;
    }
    return sum;
}

}  // namespace pbrt
