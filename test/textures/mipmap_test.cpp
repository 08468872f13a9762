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

std::shared_ptr<const MIPMap> Map(const Image &image, bool pyramid = true) {
    return MIPMap::Create(image, kSRGB, pyramid);
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

TEST(Pyramid, IsMadeOnlyWhereAskedFor) {
    EXPECT_EQ(Map(Picture({8, 8}, 1, 1), false)->NLevels(), 1);
    EXPECT_EQ(Map(Picture({8, 8}, 1, 1), true)->NLevels(), 4);
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
    const auto floats = Map(image, false);
    image.metadata.storedAs = "8-bit";
    const auto bytes = Map(image, false);
    EXPECT_EQ(bytes->MemoryBytes() * 4, floats->MemoryBytes());
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(bytes->Level(0).Get<RGB>(x, y), floats->Level(0).Get<RGB>(x, y));
    // A value between two codes: back to floats.
    image.Data()[5] = 0.5001f;
    EXPECT_EQ(Map(image, false)->MemoryBytes(), floats->MemoryBytes());
}

TEST(MIPMaps, TakeColourOrLuminanceOrTheOnlyChannel) {
    EXPECT_EQ(Map(Image({2, 2}, {"A", "B", "G", "R"}))->NChannels(), 3);
    EXPECT_EQ(Map(Image({2, 2}, {"A", "Y"}))->NChannels(), 1);
    EXPECT_EQ(Map(Image({2, 2}, {"depth"}))->NChannels(), 1);
    EXPECT_EQ(Map(Image({2, 2}, {"U", "V"})), nullptr);
}

}  // namespace
}  // namespace pbrt::test
