#include "pbrt/textures/mipmap.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace pbrt::test {
namespace {

constexpr ColorEncoding kSRGB{ColorEncoding::Kind::sRGB, 1};

Image Picture(Point2i resolution, int nChannels, uint32_t seed) {
    Image image(resolution, nChannels == 1 ? std::vector<std::string>{"Y"}
                                           : std::vector<std::string>{"R", "G", "B"});
    std::mt19937 rng(seed);
    std::uniform_real_distribution<float> value(0, 2);
    for (float &v : image.Data())
        v = value(rng);
    return image;
}

std::shared_ptr<const MIPMap> Map(const Image &image) {
    return MIPMap::Create(image, kSRGB);
}
/// The pyramid of which the level is the finest.
std::shared_ptr<const MIPMap> MapOfLevel(const MIPMap &map, int level) {
    const TexelGrid &grid = map.Level(level);
    const auto [width, height] = grid.Resolution();
    Image image({width, height}, {"Y"});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.Set({x, y}, 0, grid.Get<float>(x, y));
    return Map(image);
}

TextureSampling Sampling(TextureFilter filter, WrapMode wrap = WrapMode::Repeat) {
    TextureSampling s;
    s.filter = filter;
    s.wrap = wrap;
    return s;
}

Image Ramp() {
    Image image({4, 2}, {"Y"});
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            image.Set({x, y}, 0, float(10 * y + x));
    return image;
}

TEST(PointFilter, GivesTheTexelThatHoldsThePoint) {
    const auto map = Map(Ramp());
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            for (float off : {0.01f, 0.5f, 0.99f})
                EXPECT_EQ(map->Lookup<float>({(float(x) + off) / 4, (float(y) + off) / 2}, {},
                                             Sampling(TextureFilter::Point)),
                          float(10 * y + x));
}

TEST(BilinearFilter, MeetsTexelCentresAndIsLinearBetween) {
    const auto map = Map(Ramp());
    const auto at = [&](float x, float y) {
        return map->Lookup<float>({(x + 0.5f) / 4, (y + 0.5f) / 2}, {},
                                  Sampling(TextureFilter::Bilinear));
    };
    EXPECT_FLOAT_EQ(at(2, 1), 12);
    EXPECT_FLOAT_EQ(at(1.25f, 0), 1.25f);
    EXPECT_FLOAT_EQ(at(1.25f, 0.5f), 6.25f);
    EXPECT_FLOAT_EQ(at(3.5f, 0), 1.5f);  // between the last column and the first
}

TEST(WrapModes, RepeatClampAndBlack) {
    const auto map = Map(Ramp());
    const auto at = [&](float x, float y, WrapMode wrap) {
        return map->Lookup<float>({(x + 0.5f) / 4, (y + 0.5f) / 2}, {},
                                  Sampling(TextureFilter::Bilinear, wrap));
    };
    EXPECT_FLOAT_EQ(at(-1, 0, WrapMode::Repeat), 3);
    EXPECT_FLOAT_EQ(at(4, 3, WrapMode::Repeat), 10);
    EXPECT_FLOAT_EQ(at(-401, -40, WrapMode::Repeat), 3);
    EXPECT_FLOAT_EQ(at(-1, 0, WrapMode::Clamp), 0);
    EXPECT_FLOAT_EQ(at(7, 0, WrapMode::Clamp), 3);
    EXPECT_FLOAT_EQ(at(1e9f, 1e9f, WrapMode::Clamp), 13);
    EXPECT_FLOAT_EQ(at(4, 0, WrapMode::Black), 0);
    EXPECT_FLOAT_EQ(at(3.25f, 0, WrapMode::Black), 2.25f);
    EXPECT_FLOAT_EQ(at(-1e9f, 0, WrapMode::Black), 0);
}

TEST(Pyramid, EveryLevelKeepsTheMean) {
    for (Point2i res : {Point2i{16, 16}, Point2i{13, 7}, Point2i{1, 9}}) {
        const auto map = Map(Picture(res, 1, 4));
        const auto mean = [&](const TexelGrid &g) {
            double sum = 0;
            for (int y = 0; y < g.Resolution().y; ++y)
                for (int x = 0; x < g.Resolution().x; ++x)
                    sum += double(g.Get<float>(x, y));
            return sum / (double(g.Resolution().x) * g.Resolution().y);
        };
        EXPECT_EQ(map->Level(map->NLevels() - 1).Resolution(), (Point2i{1, 1}));
        for (int i = 1; i < map->NLevels(); ++i)
            EXPECT_NEAR(mean(map->Level(i)), mean(map->Level(0)), 2e-6);
    }
}

TEST(Pyramid, CostsAThirdMoreAndFourThirdsOfBytes) {
    Image image({64, 64}, {"R", "G", "B"});
    const size_t values = image.Data().size(), others = values / 4 * 4 / 3 - 1;
    EXPECT_EQ(Map(image)->NLevels(), 7);
    EXPECT_NEAR(double(Map(image)->MemoryBytes()), 4. * double(values + others), 16);
    image.metadata.storedAs = "8-bit";
    EXPECT_NEAR(double(Map(image)->MemoryBytes()), double(values + 4 * others), 16);
}

/// pbrt-v4's rule: levels - 1 + log2 of twice the footprint's largest component, rounded down.
TEST(PointAndBilinear, LookUpTheLevelThatFits) {
    for (const Point2i res : {Point2i{64, 64}, Point2i{64, 4}, Point2i{4, 64}, Point2i{100, 70}}) {
        const auto map = Map(Picture(res, 1, 5));
        const int last = map->NLevels() - 1;
        EXPECT_EQ(last, 6);
        const Point2f st{0.37f, 0.61f};
        // Widths of the last but one level's texel and less, a little to either side of a step.
        for (int level = 0; level <= last; ++level) {
            const auto only = MapOfLevel(*map, level);
            for (const float width : {std::exp2(float(level - last)) / 2 * 1.0001f,
                                      std::exp2(float(level - last)) * 0.9999f})
                for (const Footprint &f : {Footprint{width, 0, 0, 0}, Footprint{0, -width, 0, 0},
                                           Footprint{0, 0, -width, 0},
                                           Footprint{width / 2, width / 3, width / 4, width}})
                    for (auto filter : {TextureFilter::Point, TextureFilter::Bilinear})
                        EXPECT_EQ(map->Lookup<float>(st, f, Sampling(filter)),
                                  only->Lookup<float>(st, {}, Sampling(filter)))
                            << width << " on level " << level << " of " << res.x << " x " << res.y;
        }
    }
}

TEST(PointAndBilinear, TakeEveryFootprint) {
    const Image image = Picture({16, 16}, 1, 6);
    const auto map = Map(image);
    const float mean = map->Level(4).Get<float>(0, 0);
    constexpr float kInf = std::numeric_limits<float>::infinity();
    for (auto filter : {TextureFilter::Point, TextureFilter::Bilinear, TextureFilter::Trilinear}) {
        const auto at = [&](float width) {
            return map->Lookup<float>({0.3f, 0.4f}, {width, 0, 0, 0}, Sampling(filter));
        };
        for (const float wide : {1.f, 1e8f, 1e30f, kInf})
            EXPECT_NEAR(at(wide), mean, 1e-6f * mean);  // four weights
        for (const float narrow : {1e-6f, 1e-30f, 1e-42f, std::nanf("")})
            EXPECT_EQ(at(narrow), at(0));
    }
}

TEST(Trilinear, AtAWholeLevelIsBilinear) {
    const auto map = Map(Picture({64, 64}, 1, 5));
    for (int level = 1; level <= 6; ++level) {
        const Footprint f{std::exp2(float(level - 7)), 0, 0, 0};
        EXPECT_EQ(map->Lookup<float>({0.3f, 0.7f}, f, Sampling(TextureFilter::Trilinear)),
                  map->Lookup<float>({0.3f, 0.7f}, f, Sampling(TextureFilter::Bilinear)));
    }
}

TEST(EveryFilter, KeepsAConstantPicture) {
    Image image({32, 16}, {"R", "G", "B"});
    for (size_t i = 0; i < image.Data().size(); ++i)
        image.Data()[i] = 0.25f * float(1 + i % 3);
    const auto map = Map(image);
    std::mt19937 rng(9);
    std::uniform_real_distribution<float> place(-3, 3), step(-0.5f, 0.5f);
    for (auto filter : {TextureFilter::Point, TextureFilter::Bilinear, TextureFilter::Trilinear,
                        TextureFilter::EWA}) {
        for (int i = 0; i < 200; ++i) {
            const Footprint f{step(rng), step(rng), step(rng), step(rng)};
            const RGB c = map->Lookup<RGB>({place(rng), place(rng)}, f, Sampling(filter));
            EXPECT_NEAR(c.r, 0.25f, 1e-6);
            EXPECT_NEAR(c.g, 0.5f, 1e-6);
            EXPECT_NEAR(c.b, 0.75f, 1e-6);
        }
    }
}

TEST(PyramidFilters, WithoutFootprintAreBilinear) {
    const auto map = Map(Picture({16, 8}, 3, 2));
    for (auto filter : {TextureFilter::Trilinear, TextureFilter::EWA}) {
        const RGB a = map->Lookup<RGB>({0.3f, 0.6f}, {}, Sampling(filter));
        EXPECT_EQ(a, map->Lookup<RGB>({0.3f, 0.6f}, {}, Sampling(TextureFilter::Bilinear)));
    }
}

TEST(PyramidFilters, GrowTowardsTheMeanOfAll) {
    const Image image = Picture({64, 64}, 1, 7);
    const auto map = Map(image);
    const float mean = map->Level(map->NLevels() - 1).Get<float>(0, 0);
    for (auto filter : {TextureFilter::Trilinear, TextureFilter::EWA}) {
        const Footprint all{1, 0, 0, 1};
        EXPECT_NEAR(map->Lookup<float>({0.2f, 0.7f}, all, Sampling(filter)), mean, 1e-5);
    }
}

TEST(Trilinear, HalfwayBetweenLevelsIsTheirMean) {
    const auto map = Map(Picture({32, 32}, 1, 3));
    const Point2f st{0.37f, 0.61f};
    const auto at = [&](float texels) {
        return map->Lookup<float>(st, {texels / 32, 0, 0, texels / 32},
                                  Sampling(TextureFilter::Trilinear));
    };
    EXPECT_NEAR(at(2 * std::sqrt(2.f)), (at(2) + at(4)) / 2, 1e-5);
}

/// Stripes along t: an ellipse that is long along the stripes must not mix them, a trilinear
/// look-up of the same footprint must.
TEST(EWA, IsSharpAcrossALongFootprint) {
    Image image({64, 64}, {"Y"});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            image.Set({x, y}, 0, x / 4 % 2 == 0 ? 1.f : 0.f);
    const auto map = Map(image);
    const Footprint tall{0.5f / 64, 0, 0, 8.f / 64};
    const Point2f st{2.f / 64, 0.5f};  // middle of a bright stripe
    EXPECT_GT(map->Lookup<float>(st, tall, Sampling(TextureFilter::EWA)), 0.99f);
    EXPECT_LT(map->Lookup<float>(st, tall, Sampling(TextureFilter::Trilinear)), 0.8f);
    const Footprint wide{8.f / 64, 0, 0, 0.5f / 64};
    EXPECT_LT(map->Lookup<float>(st, wide, Sampling(TextureFilter::EWA)), 0.9f);
}

TEST(EWA, TurnsWithItsFootprint) {
    // The same picture transposed, the footprint transposed: the same value.
    const Image image = Picture({32, 32}, 1, 11);
    Image turned({32, 32}, {"Y"});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            turned.Set({y, x}, 0, image.Get({x, y}, 0));
    const auto a = Map(image), b = Map(turned);
    const Footprint f{0.15f, 0.03f, -0.01f, 0.05f}, g{0.03f, 0.15f, 0.05f, -0.01f};
    EXPECT_NEAR(a->Lookup<float>({0.3f, 0.8f}, f, Sampling(TextureFilter::EWA)),
                b->Lookup<float>({0.8f, 0.3f}, g, Sampling(TextureFilter::EWA)), 1e-5);
}

TEST(EveryFilter, AnyCoordinatesHaveAValue) {
    // uv of a mesh times uscale may overflow; no integer can hold what comes of it.
    const auto map = Map(Picture({8, 4}, 1, 9));
    const float kOdd[] = {0.3f,     -1e9f,     1e30f,         -1e38f,
                          Infinity, -Infinity, std::nanf(""), std::numeric_limits<float>::max()};
    for (const auto filter : {TextureFilter::Point, TextureFilter::Bilinear,
                              TextureFilter::Trilinear, TextureFilter::EWA})
        for (const auto wrap : {WrapMode::Repeat, WrapMode::Black, WrapMode::Clamp})
            for (const float s : kOdd)
                for (const float t : kOdd)
                    for (const float step : kOdd) {
                        const float v = map->Lookup<float>({s, t}, {step, 0, 0.1f, step},
                                                           Sampling(filter, wrap));
                        EXPECT_TRUE(v >= 0 && v <= 2) << int(filter) << ' ' << int(wrap) << ' ' << s
                                                      << ' ' << t << ' ' << step << ": " << v;
                    }
}

TEST(EightBitPictures, StayBytesWithoutLoss) {
    Image image({16, 16}, {"R", "G", "B"});
    for (size_t i = 0; i < image.Data().size(); ++i)
        image.Data()[i] = kSRGB.ToLinear(float(i % 256) / 255);
    const auto floats = Map(image);
    image.metadata.storedAs = "8-bit";
    const auto bytes = Map(image);
    EXPECT_EQ(bytes->Level(0).MemoryBytes() * 4, floats->Level(0).MemoryBytes());
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(bytes->Level(0).Get<RGB>(x, y), floats->Level(0).Get<RGB>(x, y));
    // A value between two codes: back to floats.
    image.Data()[5] = 0.5001f;
    EXPECT_EQ(Map(image)->MemoryBytes(), floats->MemoryBytes());
}

TEST(MIPMaps, TakeColourOrLuminanceOrTheOnlyChannel) {
    EXPECT_EQ(Map(Image({2, 2}, {"A", "B", "G", "R"}))->NChannels(), 3);
    EXPECT_EQ(Map(Image({2, 2}, {"A", "Y"}))->NChannels(), 1);
    EXPECT_EQ(Map(Image({2, 2}, {"depth"}))->NChannels(), 1);
    EXPECT_EQ(Map(Image({2, 2}, {"U", "V"})), nullptr);
}

TEST(MIPMaps, HaveAlphaWhereItIsNotOneEverywhere) {
    Image image({3, 2}, {"R", "G", "B", "A"});
    const auto setAlpha = [&](float v) {
        for (int i = 0; i < 6; ++i)
            image.Set({i % 3, i / 3}, 3, v);
    };
    EXPECT_TRUE(MIPMap::HasAlpha(image));  // 0 everywhere
    EXPECT_TRUE(Map(image)->LeavesOutAlpha());
    setAlpha(1);
    EXPECT_FALSE(MIPMap::HasAlpha(image));
    EXPECT_FALSE(Map(image)->LeavesOutAlpha());
    image.Set({2, 1}, 3, 254 / 255.f);
    EXPECT_TRUE(MIPMap::HasAlpha(image));
    const auto alpha = MIPMap::CreateOfAlpha(image);
    EXPECT_EQ(alpha->NChannels(), 1);
    EXPECT_EQ(alpha->Level(0).Get<float>(2, 1), 254 / 255.f);
    EXPECT_FALSE(alpha->LeavesOutAlpha());
    EXPECT_FALSE(MIPMap::HasAlpha(Image({2, 2}, {"Y", "A"})));
    EXPECT_FALSE(MIPMap::HasAlpha(Image({2, 2}, {"R", "G", "B"})));
    EXPECT_FALSE(MIPMap::HasAlpha(Image({2, 2}, {"A"})));
}

}  // namespace
}  // namespace pbrt::test
