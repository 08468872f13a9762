#include "pbrt/imgtool/flip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pbrt/util/matrix.h"

namespace pbrt::imgtool {
namespace {

// Names and constants are those of the paper; colors are linear sRGB, YCxCz or L*a*b* under D65.

constexpr double kPixelsPerDegree = 67.0206;  // 0.7 m * (3840 / 0.7 m) * pi / 180

using Color = std::array<double, 3>;

/// One color a pixel.
struct Plane {
    int width, height;
    std::vector<Color> pixels;

    Plane(int width, int height)
        : width(width), height(height), pixels(size_t(width) * size_t(height)) {}
    Color &At(int x, int y) { return pixels[size_t(y) * size_t(width) + size_t(x)]; }
    /// Outside as at the border.
    const Color &Near(int x, int y) const {
        return pixels[size_t(std::clamp(y, 0, height - 1)) * size_t(width) +
                      size_t(std::clamp(x, 0, width - 1))];
    }
};

// As the authors' program has them: white is the sum of the columns.
constexpr Matrix3d kXYZFromRGB{{{10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794},
                                {2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897},
                                {1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382}}};
constexpr Matrix3d kRGBFromXYZ{{{3.241003275, -1.537398934, -0.498615861},
                                {-0.969224334, 1.875930071, 0.041554224},
                                {0.055639423, -0.204011202, 1.057148933}}};

/// XYZ over that of white.
Color RelativeXYZ(const Color &rgb) {
    static const Color white = Mul(kXYZFromRGB, Color{1, 1, 1});
    Color xyz = Mul(kXYZFromRGB, rgb);
    for (size_t i = 0; i < 3; ++i)
        xyz[i] /= white[i];
    return xyz;
}
Color YCxCz(const Color &rgb) {
    const Color t = RelativeXYZ(rgb);
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}
Color RGBOfYCxCz(const Color &c) {
    static const Color white = Mul(kXYZFromRGB, Color{1, 1, 1});
    const double y = (c[0] + 16) / 116;
    return Mul(kRGBFromXYZ,
               Color{white[0] * (y + c[1] / 500), white[1] * y, white[2] * (y - c[2] / 200)});
}
Color Lab(const Color &rgb) {
    constexpr double kDelta = 6. / 29;
    Color t = RelativeXYZ(rgb);
    for (double &v : t)
        v = v > kDelta * kDelta * kDelta ? std::cbrt(v) : v / (3 * kDelta * kDelta) + 4. / 29;
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}
/// Hunt effect: chroma counts less in the dark.
Color HuntAdjusted(Color lab) {
    lab[1] *= 0.01 * lab[0];
    lab[2] *= 0.01 * lab[0];
    return lab;
}
double HyAB(const Color &a, const Color &b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// Contrast sensitivity of a channel, a sum of two Gaussians in space.
struct Sensitivity {
    double a1, b1, a2, b2;
    double At(double squaredDegrees) const {
        const auto gauss = [&](double a, double b) {
            return a * std::sqrt(M_PI / b) * std::exp(-M_PI * M_PI * squaredDegrees / b);
        };
        return gauss(a1, b1) + gauss(a2, b2);
    }
};
constexpr std::array<Sensitivity, 3> kSensitivities{
    {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};

/// The picture as blurred as the eye sees it, in linear sRGB, clamped to [0, 1].
Plane Filtered(const Plane &picture) {
    // Three standard deviations of the widest Gaussian.
    const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * M_PI * M_PI)) * kPixelsPerDegree));
    const int size = 2 * radius + 1;
    std::array<std::vector<double>, 3> weights;
    for (size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (int i = 0; i < size * size; ++i) {
            const double x = (i % size - radius) / kPixelsPerDegree,
                         y = (i / size - radius) / kPixelsPerDegree;
            weights[c].push_back(kSensitivities[c].At(x * x + y * y));
            sum += weights[c].back();
        }
        for (double &w : weights[c])
            w /= sum;
    }
    Plane out(picture.width, picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            Color sum{};
            for (int i = 0; i < size * size; ++i) {
                const Color &from = picture.Near(x + i % size - radius, y + i / size - radius);
                for (size_t c = 0; c < 3; ++c)
                    sum[c] += weights[c][size_t(i)] * from[c];
            }
            Color rgb = RGBOfYCxCz(sum);
            for (double &v : rgb)
                v = std::clamp(v, 0., 1.);
            out.At(x, y) = rgb;
        }
    return out;
}

/// Filters for edges (the first derivative of a Gaussian) and points (the second) along x; positive
/// and negative weights have sum 1 and -1.
struct FeatureFilters {
    int radius;
    std::vector<double> edge, point, across;

    FeatureFilters() {
        const double deviation = 0.5 * 0.082 * kPixelsPerDegree;
        radius = int(std::ceil(3 * deviation));
        double sum = 0, edges = 0, points[2] = {};
        for (int x = -radius; x <= radius; ++x) {
            const double g = std::exp(-x * x / (2 * deviation * deviation));
            across.push_back(g);
            edge.push_back(-x * g);
            point.push_back((x * x / (deviation * deviation) - 1) * g);
            sum += g;
            edges += std::max(0., edge.back());
            points[0] += std::max(0., point.back());
            points[1] += std::max(0., -point.back());
        }
        for (size_t i = 0; i < across.size(); ++i) {
            across[i] /= sum;
            edge[i] /= edges;
            point[i] /= points[point[i] > 0 ? 0 : 1];
        }
    }
    /// Responses of the picture's brightness, in [0, 1], at each pixel: the sizes of the vectors of
    /// edges {0} and of points {1}.
    std::array<double, 2> At(const Plane &picture, int x, int y) const {
        double ex = 0, ey = 0, px = 0, py = 0;
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i) {
                const double v = (picture.Near(x + i, y + j)[0] + 16) / 116;
                const size_t a = size_t(i + radius), b = size_t(j + radius);
                ex += edge[a] * across[b] * v;
                ey += across[a] * edge[b] * v;
                px += point[a] * across[b] * v;
                py += across[a] * point[b] * v;
            }
        return {std::hypot(ex, ey), std::hypot(px, py)};
    }
};

/// Error of color alone, from HyAB's distance, in [0, 1]: the largest, from green to blue, is 1,
/// and 0.4 of it becomes 0.95.
double ColorError(double distance) {
    constexpr double kExponent = 0.7, kShare = 0.4, kTo = 0.95;
    static const double most =
        std::pow(HyAB(HuntAdjusted(Lab({0, 1, 0})), HuntAdjusted(Lab({0, 0, 1}))), kExponent);
    const double d = std::pow(distance, kExponent), knee = kShare * most;
    return d < knee ? kTo / knee * d : kTo + (d - knee) / (most - knee) * (1 - kTo);
}

Plane ToYCxCz(const Image &image) {
    const auto [width, height] = image.Resolution();
    const int index[3] = {image.ChannelIndex("R"), image.ChannelIndex("G"),
                          image.ChannelIndex("B")};
    Plane plane(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Color rgb;
            for (size_t c = 0; c < 3; ++c) {
                const double v = image.Get({x, y}, index[c]);
                rgb[c] = v > 0 ? std::min(v, 1.) : 0;
            }
            plane.At(x, y) = YCxCz(rgb);
        }
    return plane;
}

}  // namespace

Image Flip(const Image &image, const Image &reference) {
    const Plane a = ToYCxCz(image), b = ToYCxCz(reference);
    const Plane seenA = Filtered(a), seenB = Filtered(b);
    const FeatureFilters features;
    Image error(image.Resolution(), {"Y"});
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const Color &p = seenA.Near(x, y), &q = seenB.Near(x, y);
            // Two roundings of one number are no difference.
            const double color =
                p == q ? 0 : ColorError(HyAB(HuntAdjusted(Lab(p)), HuntAdjusted(Lab(q))));
            const auto fa = features.At(a, x, y), fb = features.At(b, x, y);
            const double feature =
                std::sqrt(M_SQRT1_2 * std::max(std::abs(fa[0] - fb[0]), std::abs(fa[1] - fb[1])));
            error.Set({x, y}, 0, float(std::pow(color, 1 - feature)));
        }
    return error;
}

}  // namespace pbrt::imgtool
