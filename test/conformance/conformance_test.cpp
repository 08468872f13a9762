// Small scenes beside what pbrt-v4 makes of them; see README.md here.

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "pbrt/util/read_file.h"
#include "render/render_text.h"
#include "support/folders.h"

namespace pbrt::test {
namespace {

/// A line of index.txt.
struct Scene {
    std::string name, expected;
    double spp = 0;                 ///< of the reference
    std::array<double, 3> sigma{};  ///< of a tile's mean, of the reference
};

void PrintTo(const Scene &scene, std::ostream *to) {
    *to << scene.name;
}

std::string Folder() {
    return SourceDir() + "/test/conformance";
}

std::vector<Scene> Scenes() {
    std::ifstream index(Folder() + "/index.txt");
    std::vector<Scene> scenes;
    for (std::string line; std::getline(index, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        Scene s;
        words >> s.name >> s.expected >> s.spp >> s.sigma[0] >> s.sigma[1] >> s.sigma[2];
        scenes.push_back(s);
    }
    return scenes;
}

constexpr int kTile = 8;

/// Means of the tiles of a channel, row by row.
std::vector<double> TileMeans(const Image &image, int channel) {
    const Point2i n{image.Resolution().x / kTile, image.Resolution().y / kTile};
    std::vector<double> means(size_t(n.x * n.y));
    for (int y = 0; y < n.y * kTile; ++y)
        for (int x = 0; x < n.x * kTile; ++x)
            means[size_t(y / kTile * n.x + x / kTile)] +=
                double(image.Get({x, y}, channel)) / (kTile * kTile);
    return means;
}

/// A channel of two images against its noise.
struct Difference {
    double mean = 0;       ///< of the reference
    double ofMeans = 0;    ///< ours less the reference's
    double meanSigma = 0;  ///< standard error of that
    double tileZ = 0;      ///< root of the mean square of the tiles' differences over their noise
};
/// `sigma`: standard error of the difference of a tile.
Difference Compare(const Image &ours, const Image &reference, int channel, double sigma) {
    const auto a = TileMeans(ours, channel), b = TileMeans(reference, channel);
    Difference d;
    double squares = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        d.mean += b[i] / double(a.size());
        d.ofMeans += (a[i] - b[i]) / double(a.size());
        squares += Sqr((a[i] - b[i]) / sigma);
    }
    d.meanSigma = sigma / std::sqrt(double(a.size()));
    d.tileZ = std::sqrt(squares / double(a.size()));
    return d;
}

/// The samples per pixel that a scene asks for.
double SamplesOf(const std::string &text) {
    constexpr std::string_view kName = "pixelsamples\"";
    return std::stod(text.substr(text.find(kName) + kName.size()));
}

/// Ends with messages that say that something is not there.
void ExpectRefused(const std::string &text) {
    Diagnostics log;
    SceneDescription description;
    ParseString(text, "test.pbrt", Folder() + "/scenes", description, log);
    EXPECT_FALSE(MakeRenderTask(std::move(description), {}, log));
    bool said = false;
    for (const Message &m : log.Messages())
        said |= m.text.find("not built here") != m.text.npos ||
                m.text.find("not supported") != m.text.npos ||
                m.text.find("is not one of") != m.text.npos ||
                m.text.find("stretched") != m.text.npos;
    EXPECT_TRUE(said);
}

class Conformance : public testing::TestWithParam<Scene> {};

/// Means agree within 0.5 % or three standard errors. Tiles agree within noise: their z has a root
/// mean square of 1 but for the estimate of our noise, which is taken to be pbrt-v4's at as many
/// samples; 1.6 leaves a chance below 1e-9 over 64 tiles, and room for that estimate.
TEST_P(Conformance, WithPbrtV4) {
    const Scene &scene = GetParam();
    const std::string file = Folder() + "/scenes/" + scene.name + ".pbrt";
    const std::string text = *ReadWholeFile(file).bytes;
    if (scene.expected == "refused") return ExpectRefused(text);
    const Image ours = RenderText(text, {}, Folder() + "/scenes");
    const OrError<Image> reference = ReadImage(Folder() + "/reference/" + scene.name + ".exr");
    ASSERT_TRUE(reference) << reference.error;
    ASSERT_EQ(ours.Resolution(), reference.value->Resolution());
    bool differs = false;
    for (int c = 0; c < 3; ++c) {
        const double sigma = scene.sigma[size_t(c)] * std::sqrt(1 + scene.spp / SamplesOf(text));
        const Difference d = Compare(ours, *reference.value, c, sigma);
        if (scene.expected == "differs") {
            differs |= d.tileZ > 1.6 || std::abs(d.ofMeans) > std::max(0.005 * d.mean, 3 * sigma);
            continue;
        }
        EXPECT_NEAR(d.ofMeans / d.mean, 0, std::max(0.005, 3 * d.meanSigma / d.mean))
            << "channel " << c;
        if (scene.expected == "agrees") {
            EXPECT_LT(d.tileZ, 1.6) << "channel " << c;
        }
    }
    if (scene.expected == "differs") {
        EXPECT_TRUE(differs) << "agrees now: index.txt and docs/DIFFERENCES.md are out of date";
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Conformance, testing::ValuesIn(Scenes()), [](const auto &info) {
    std::string name = info.param.name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
});

/// docs/DIFFERENCES.md names every scene that differs, and no other.
TEST(Differences, NameTheScenes) {
    const auto read = ReadWholeFile(SourceDir() + "/docs/DIFFERENCES.md");
    ASSERT_TRUE(read.bytes);
    const std::string &document = *read.bytes;
    for (const Scene &scene : Scenes())
        EXPECT_EQ(document.find(fmt::format("`{}`", scene.name)) != std::string::npos,
                  scene.expected == "differs")
            << scene.name;
}

}  // namespace
}  // namespace pbrt::test
