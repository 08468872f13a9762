// A render is a list of pieces: any split, any order, any part of the image has the same bits.

#include "pbrt/render/pieces.h"

#include <fmt/format.h>

#include "pbrt/util/rng.h"
#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// A random scene of balls on a floor: every material, mixes and coplanar triangles included (what
/// of two surfaces in one place is met is decided by roundings), every film and integrator.
std::string RandomScene(int number, Point2i resolution, const std::string &film, int spp) {
    Rng rng{uint64_t(number)};
    const auto in = [&](double a, double b) { return a + (b - a) * rng.Uniform(); };
    const auto pick = [&](const std::vector<std::string> &from) {
        return from[std::min(size_t(rng.Uniform() * double(from.size())), from.size() - 1)];
    };
    const std::vector<std::string> materials{
        "Material \"diffuse\"",        "Material \"featherbarbule\" \"float spacing\" 1.5",
        "Material \"featherbarbule\"", "Material \"conductor\" \"float roughness\" .2",
        "Material \"dielectric\"",     "Material \"coateddiffuse\"",
        "Material \"hair\"",           "Material \"mix\" \"string materials\" [ \"a\" \"b\" ]"};
    const std::string integrator =
        pick({"path", "path", "path", "simplepath", "randomwalk", "ambientocclusion"});
    std::string text = fmt::format(
        "LookAt {} 1.5 -4  0 .4 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
        "Film \"{}\" \"integer xresolution\" {} \"integer yresolution\" {} {}\n"
        "Sampler \"{}\" {}\nIntegrator \"{}\"\nWorldBegin\n"
        "LightSource \"infinite\" \"rgb L\" [ .3 .4 .5 ]\n"
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 4 4 4 ] Translate 0 3 0\n"
        "Shape \"sphere\" \"float radius\" .6 AttributeEnd\n"
        "MakeNamedMaterial \"a\" \"string type\" \"featherbarbule\" \"float spacing\" 2\n"
        "MakeNamedMaterial \"b\" \"string type\" \"conductor\"\n"
        "Material \"diffuse\"\n"
        "Shape \"trianglemesh\" \"point3 P\" [ -3 0 -3 3 0 -3 -3 0 3 3 0 3 ] \"integer indices\" "
        "[ 0 1 2 1 3 2 ]\n"
        "Material \"conductor\"\n"
        "Shape \"trianglemesh\" \"point3 P\" [ -3 0 -3 3 0 -3 -3 0 3 3 0 3 ] \"integer indices\" "
        "[ 0 1 3 0 3 2 ]\n",
        in(-2, 2), pick({"rgb", "gbuffer", "spectral"}), resolution.x, resolution.y, film,
        pick({"zsobol", "independent", "halton", "sobol", "paddedsobol", "pmj02bn"}),
        fmt::format("\"integer pixelsamples\" {}", spp), integrator);
    for (int i = 0; i < 6; ++i)
        text += fmt::format(
            "AttributeBegin {} Translate {} {} {} Shape \"sphere\" \"float radius\" {} "
            "AttributeEnd\n",
            pick(materials), in(-1.5, 1.5), in(0, 1), in(-1, 2), in(.1, .5));
    return text;
}

RenderTask TaskOf(const std::string &text) {
    Diagnostics log;
    SceneDescription description;
    ParseString(text, "test.pbrt", ".", description, log);
    auto task = MakeRenderTask(std::move(description), {}, log);
    for (const Message &m : log.Messages())
        ADD_FAILURE() << m.text;
    return std::move(*task);
}

void ExpectPartOf(const Image &part, const Image &whole, const std::string &what) {
    const auto &b = part.metadata.pixelBounds;
    for (int y = b[2]; y < b[3]; ++y)
        for (int x = b[0]; x < b[1]; ++x)
            for (int c = 0; c < part.NChannels(); ++c)
                ASSERT_EQ(part.Get({x - b[0], y - b[2]}, c), whole.Get({x, y}, c))
                    << what << ", pixel " << x << ", " << y << ", "
                    << part.ChannelNames()[size_t(c)];
}

TEST(Pieces, BlocksOfSamplesFollowOneAnother) {
    for (const int spp : {1, 2, 3, 12, 64, 65, 200, 1000}) {
        int next = 0;
        for (SampleRange b = BlockAt(0, spp); b.Size() > 0; b = BlockAt(b.last, spp)) {
            EXPECT_EQ(b.first, next);
            EXPECT_LE(b.Size(), kLargestBlock);
            next = b.last;
        }
        EXPECT_EQ(next, spp);
    }
    EXPECT_EQ(BlockAt(0, 1000).last, 1);
    EXPECT_EQ(BlockAt(16, 1000).last, 32);
}

TEST(Pieces, TilesCoverACropAndHaveTheWholesBorders) {
    const RenderTask whole = TaskOf(RandomScene(1, {70, 50}, "", 1));
    const RenderTask part =
        TaskOf(RandomScene(1, {70, 50}, "\"integer pixelbounds\" [ 17 70 15 16 ]", 1));
    const auto tiles = TilesOf(whole.scene->film), some = TilesOf(part.scene->film);
    int64_t area = 0;
    for (const PixelBounds &tile : tiles)
        area += tile.Area();
    EXPECT_EQ(area, 70 * 50);
    for (const PixelBounds &tile : some)
        EXPECT_NE(std::find(tiles.begin(), tiles.end(), tile), tiles.end());
    EXPECT_EQ(some.size(), 4u);
}

TEST(Pieces, AnyCropIsThatPartOfTheImage) {
    constexpr int kScenes = 24;
    const Point2i resolution{40, 24};
    for (int number = 0; number < kScenes; ++number) {
        const int spp = number % 3 == 0 ? 16 : 4;
        const Image whole = RenderText(RandomScene(number, resolution, "", spp));
        Rng rng{1000 + uint64_t(number)};
        for (int k = 0; k < 2; ++k) {
            const int x = int(rng.Uniform() * 39), y = int(rng.Uniform() * 23);
            const int x1 = k == 0 ? x + 1 : x + 1 + int(rng.Uniform() * (39 - x));
            const int y1 = k == 0 ? y + 1 : y + 1 + int(rng.Uniform() * (23 - y));
            const std::string crop =
                fmt::format("\"integer pixelbounds\" [ {} {} {} {} ]", x, x1, y, y1);
            ExpectPartOf(RenderText(RandomScene(number, resolution, crop, spp)), whole,
                         fmt::format("scene {}, {}", number, crop));
        }
    }
}

TEST(Pieces, AnyOrderAndSplitGivesTheSameBits) {
    for (int number = 0; number < 8; ++number) {
        const RenderTask task = TaskOf(RandomScene(number, {40, 24}, "", 16));
        const Film &film = task.scene->film;
        Image expected;
        ASSERT_TRUE(Render(task, 2, GoOn, &expected));
        std::vector<Piece> pieces = PiecesOf(film, 16);
        Rng rng{uint64_t(number)};
        for (size_t i = pieces.size(); i > 1; --i)
            std::swap(pieces[i - 1], pieces[size_t(rng.Uniform() * double(i))]);
        TileSums sums(film);
        const std::span<const Piece> all = pieces;
        for (size_t done = 0; done < pieces.size();) {
            const size_t n = std::min(pieces.size() - done, 1 + size_t(rng.Uniform() * 9));
            ASSERT_TRUE(AddPieces(task, all.subspan(done, n), 1 + int(done % 2), GoOn, &sums));
            done += n;
        }
        Image image = film.NewImage();
        sums.Develop(&image);
        EXPECT_EQ(image.Data(), expected.Data()) << number;
    }
}

TEST(Pieces, ATargetErrorsCropIsThatPartOfTheImage) {
    const auto render = [](const std::string &film) {
        Diagnostics log;
        SceneDescription description;
        ParseString(RandomScene(3, {48, 32}, film, 128), "test.pbrt", ".", description, log);
        Overrides overrides;
        overrides.targetError = 0.1f;
        return RenderAll(*MakeRenderTask(std::move(description), overrides, log)).image;
    };
    ExpectPartOf(render("\"integer pixelbounds\" [ 9 30 5 20 ]"), render(""), "target error");
}

TEST(ExactSum, DoesNotDependOnOrder) {
    Rng rng(7);
    std::vector<double> values;
    for (int i = 0; i < 10000; ++i)
        values.push_back((rng.Uniform() - 0.3) * std::pow(10, 40 * rng.Uniform() - 25));
    ExactSum forward, backward, halves, half;
    for (size_t i = 0; i < values.size(); ++i) {
        forward += values[i];
        backward += values[values.size() - 1 - i];
        (i % 2 ? half : halves) += values[i];
    }
    halves += half;
    EXPECT_EQ(forward, backward);
    EXPECT_EQ(forward, halves);
}

TEST(ExactSum, ErrsByLessThanItsStep) {
    for (const double x : {0., 1., -1., 0.1, -0.1, 1e-12, -1e-12, 3e18, -3e18, 123456.789, 1e-30}) {
        ExactSum sum;
        sum += x;
        EXPECT_LE(std::abs(sum.Value() - x), 0x1p-63 + std::abs(x) * 0x1p-53) << x;
        sum += -x;
        EXPECT_LE(std::abs(sum.Value()), 0x1p-62) << x;
    }
    ExactSum large;
    large += 1e300;
    EXPECT_EQ(large.Value(), ExactSum::kLargest);
}

/// Beyond what it holds it stops, and keeps its sign.
TEST(ExactSum, StopsAtItsEnds) {
    for (const double sign : {1., -1.}) {
        ExactSum sum, twice;
        for (int i = 0; i < 5; ++i)
            sum += sign * 1e300;
        EXPECT_NEAR(sign * sum.Value() / 0x1p63, 1, 1e-9);
        twice += sum;
        twice += sum;
        EXPECT_EQ(twice, sum);
    }
}

}  // namespace
}  // namespace pbrt::test
