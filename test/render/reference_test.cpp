// Pictures agree with those that pbrt-v4 makes of the same scenes: units, film, colours, lights.

#include <fstream>
#include <regex>
#include <sstream>

#include "render/render_text.h"
#include "support/folders.h"

namespace pbrt::test {
namespace {

const std::string kData = SourceDir() + "/test/render/data/";

std::string SceneAt100(const std::string &name) {
    std::ifstream file(kData + name + ".pbrt");
    std::stringstream text;
    text << file.rdbuf();
    return std::regex_replace(text.str(), std::regex("resolution\" \\[ 400 \\]"),
                              "resolution\" [ 100 ]");
}

/// Means of `size` x `size` tiles, channel by channel.
std::vector<double> TileMeans(const Image &image, int size) {
    std::vector<double> means;
    for (int c = 0; c < 3; ++c)
        for (int ty = 0; ty < image.Resolution().y; ty += size)
            for (int tx = 0; tx < image.Resolution().x; tx += size) {
                double sum = 0;
                for (int y = ty; y < ty + size; ++y)
                    for (int x = tx; x < tx + size; ++x)
                        sum += image.Get({x, y}, c);
                means.push_back(sum / (size * size));
            }
    return means;
}

/// Variances of tile means of the reference: per-pixel differences to a picture of 1/16 of the
/// samples hold 17/16 of the latter's variance.
std::vector<double> ReferenceVariance(const Image &reference, const Image &fewer, int size) {
    Image squared = reference;
    for (size_t i = 0; i < squared.Data().size(); ++i)
        squared.Data()[i] = Sqr(reference.Data()[i] - fewer.Data()[i]);
    std::vector<double> variance = TileMeans(squared, size);
    for (double &v : variance)
        v /= 17.0 * size * size;
    return variance;
}

struct Comparison {
    std::array<double, 3> meanRatio;
    std::vector<double> z;  ///< per tile, channel by channel
    int tilesPerRow;
};

Comparison Compare(const std::string &name, int runs, int spp) {
    constexpr int kTile = 10;
    const Image reference = *ReadImage(kData + name + ".exr").value;
    const Image fewer = *ReadImage(kData + name + "-256.exr").value;
    const std::string text = SceneAt100(name);
    std::vector<std::vector<double>> means;
    std::array<double, 3> mean{};
    for (int seed = 0; seed < runs; ++seed) {
        const Image image = RenderText(text, {.seed = seed, .spp = spp});
        means.push_back(TileMeans(image, kTile));
        for (int c = 0; c < 3; ++c)
            mean[c] += Mean(image)[c] / runs;
    }
    Comparison result;
    result.tilesPerRow = reference.Resolution().x / kTile;
    for (int c = 0; c < 3; ++c)
        result.meanRatio[c] = mean[c] / Mean(reference)[c];
    const std::vector<double> expected = TileMeans(reference, kTile);
    const std::vector<double> variance = ReferenceVariance(reference, fewer, kTile);
    for (size_t i = 0; i < expected.size(); ++i) {
        double sum = 0, sumSqr = 0;
        for (const auto &m : means)
            sum += m[i], sumSqr += m[i] * m[i];
        const double ours = sum / runs;
        const double own = std::max(0.0, sumSqr / runs - ours * ours) / (runs - 1);
        result.z.push_back((ours - expected[i]) / std::sqrt(own + variance[i] + 1e-12));
    }
    return result;
}

/// Correlation of neighbouring tiles' z: structure that noise does not have.
double NeighbourCorrelation(const Comparison &c) {
    double products = 0, squares = 0;
    int pairs = 0;
    for (size_t i = 0; i + 1 < c.z.size(); ++i) {
        if ((i + 1) % c.tilesPerRow == 0) continue;
        products += c.z[i] * c.z[i + 1];
        ++pairs;
    }
    for (double z : c.z)
        squares += z * z;
    return (products / pairs) / (squares / double(c.z.size()));
}

TEST(Reference, MatteSpheres) {
    const Comparison c = Compare("matte-spheres", 12, 32);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(c.meanRatio[k], 1, 0.005) << "channel " << k;
    // 300 tiles, Sidak at 0.01 overall: Student's t with 11 degrees of freedom, 6.6 sigma.
    for (size_t i = 0; i < c.z.size(); ++i)
        EXPECT_LT(std::abs(c.z[i]), 6.6) << "tile " << i;
    // 100 independent tiles, three correlated channels: standard error of the correlation 0.1.
    EXPECT_LT(NeighbourCorrelation(c), 0.35);
}

TEST(Reference, GlassCausticWithinItsNoise) {
    const Comparison c = Compare("glass-caustic", 12, 64);
    // Fireflies: the caustics' variance is itself poorly known, so the bound is wider than for
    // matte surfaces (standard error of the mean about 0.7 %).
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(c.meanRatio[k], 1, 0.02) << "channel " << k;
    std::vector<double> sizes;
    for (double z : c.z)
        sizes.push_back(std::abs(z));
    std::sort(sizes.begin(), sizes.end());
    // Fireflies make single tiles deviate; the median of |z| is 0.70 for Student's t.
    EXPECT_LT(sizes[sizes.size() / 2], 1.1);
    EXPECT_GT(sizes[sizes.size() / 2], 0.4);
}

}  // namespace
}  // namespace pbrt::test
