// Lights whose picture is seen from one place or through a window, and pictures on shapes.

#include <fmt/format.h>

#include "lights/light_scene.h"
#include "pbrt/image/image.h"
#include "pbrt/lights/windowed_distribution.h"
#include "pbrt/util/equal_area.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"
#include "support/chi_square.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

Image Filled(Point2i size, float value) {
    Image image(size, {"R", "G", "B"});
    std::fill(image.Data().begin(), image.Data().end(), value);
    return image;
}
void SetGray(Image *image, Point2i p, float value) {
    for (int c = 0; c < 3; ++c)
        image->Set(p, c, value);
}
/// Values that differ from texel to texel, and a bright spot.
Image Uneven(int n) {
    Image image = Filled({n, n}, 0);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            SetGray(&image, {x, y}, 0.2f + float((7 * x + 5 * y) % 11) / 10);
    SetGray(&image, {n / 3, n / 2}, 20);
    return image;
}

/// L over white light of the renderer's unit.
float Level(const SampledSpectrum &L) {
    const Spectrum &white = RGBColorSpace::sRGB().Illuminant();
    return L[0] / white.Sample(kLambda)[0] * SpectrumToPhotometric(white);
}

class PictureLights : public TempFolder {
  protected:
    void Write(const Image &image) const {
        ASSERT_EQ(WriteImage(image, Path("p.exr"), ExrPixels::Float), std::nullopt);
    }
    LightScene Scene(const std::string &text) const { return LightScene(text, folder.string()); }
    /// The light's intensity in direction w, seen at distance 1; it stands at the origin.
    static float Intensity(const Light &light, Vector3f w) {
        const auto s = SampleLi(light, {Point3f(w), {}}, {0.5f, 0.5f}, kLambda);
        return s ? Level(s->L) : 0;
    }
    /// Over all directions: midpoints of an equal-area grid.
    static double Flux(const Light &light) {
        constexpr int n = 512;
        double sum = 0;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                sum += double(Intensity(light, EqualAreaSquareToSphere(Point2f{
                                                   (float(x) + 0.5f) / n, (float(y) + 0.5f) / n})));
        return sum * 4 * double(Pi) / (n * n);
    }
};

TEST_F(PictureLights, GoniometricShinesByThePicture) {
    Image image = Filled({5, 5}, 0.25f);
    SetGray(&image, {2, 2}, 2);  // +z of the picture
    SetGray(&image, {4, 2}, 3);  // +x
    SetGray(&image, {2, 4}, 4);  // +y
    Write(image);
    const LightScene s =
        Scene("LightSource \"goniometric\" \"string filename\" \"p.exr\" \"rgb I\" [ 2 2 2 ]");
    // y and z are exchanged.
    EXPECT_NEAR(Intensity(s.Only(), {0, 1, 0}), 2 * 2, 2e-3);
    EXPECT_NEAR(Intensity(s.Only(), {1, 0, 0}), 2 * 3, 2e-3);
    EXPECT_NEAR(Intensity(s.Only(), {0, 0, 1}), 2 * 4, 2e-3);
    EXPECT_NEAR(Intensity(s.Only(), {0, -1, 0}), 2 * 0.25, 2e-3);
}

TEST_F(PictureLights, GoniometricMeetsItsPower) {
    Write(Uneven(16));
    const LightScene s = Scene(
        "Rotate 30 1 2 3 LightSource \"goniometric\" \"string filename\" \"p.exr\" \"float power\" "
        "40");
    EXPECT_NEAR(Flux(s.Only()), 40, 0.1);  // the grid cuts texels
    EXPECT_NEAR(Power(s.Only()), 40, 0.1);
}

TEST_F(PictureLights, ProjectionThrowsThePictureUpright) {
    // 4 x 2: the shorter side, vertical, subtends 90 degrees.
    Image image = Filled({4, 2}, 0);
    SetGray(&image, {0, 0}, 1);  // top left
    SetGray(&image, {3, 1}, 2);  // bottom right
    Write(image);
    const LightScene s = Scene("LightSource \"projection\" \"string filename\" \"p.exr\"");
    const auto along = [&](float x, float y, float z) {
        return Intensity(s.Only(), Normalize(Vector3f{x, y, z}));
    };
    EXPECT_NEAR(along(-1.5f, 0.5f, 1), 1, 1e-3);
    EXPECT_NEAR(along(1.5f, -0.5f, 1), 2, 2e-3);
    EXPECT_EQ(along(1.5f, 0.5f, 1), 0);
    // The picture ends at 2 and 1, and lies on one side.
    EXPECT_NEAR(along(-1.99f, 0.99f, 1), 1, 1e-3);
    EXPECT_EQ(along(-2.01f, 0.5f, 1), 0);
    EXPECT_EQ(along(-1.5f, 1.01f, 1), 0);
    EXPECT_EQ(along(1.5f, -0.5f, -1), 0);
}

TEST_F(PictureLights, ProjectionMeetsItsPower) {
    Write(Uneven(8));
    const LightScene s = Scene(
        "Rotate 30 1 2 3 LightSource \"projection\" \"string filename\" \"p.exr\" \"float fov\" 70 "
        "\"float power\" 40");
    EXPECT_NEAR(Flux(s.Only()), 40, 0.5);  // texels' edges, and their middles for the whole
    EXPECT_NEAR(Power(s.Only()), 40, 1e-3);
}

TEST(WindowedDistribution, DrawsWithinWindows) {
    Rng rng(1);
    constexpr int n = 7, bins = 5, samples = 100000;
    std::vector<float> weights(n * n);
    for (float &w : weights)
        w = rng.Below(4) == 0 ? 0 : rng.Uniform();
    const WindowedDistribution d(weights, n);
    const std::array<Window, 4> windows{
        Window{{0, 0}, {1, 1}}, Window{{0.21f, 0.4f}, {0.77f, 0.93f}},
        Window{{0.3f, 0.1f}, {0.31f, 0.95f}}, Window{{0.58f, 0.44f}, {0.7f, 0.56f}}};
    for (const Window &w : windows) {
        const Vector2f size = w.max - w.min;
        std::vector<double> counts(bins * bins), expected(bins * bins);
        const auto bin = [&](Point2f p) {
            const auto at = [](float x) { return std::clamp(int(x * bins), 0, bins - 1); };
            return size_t(at((p.y - w.min.y) / size.y) * bins + at((p.x - w.min.x) / size.x));
        };
        int same = 0;
        for (int i = 0; i < samples; ++i) {
            const auto s = d.Draw(rng.Uniform2D(), w);
            ASSERT_TRUE(s);
            counts[bin(s->p)] += 1;
            same += std::abs(d.PDF(s->p, w) / s->pdf - 1) < 1e-5f;
        }
        EXPECT_GT(same, samples * 0.999);  // rounding at a cell's border
        constexpr int fine = 1000;
        for (int y = 0; y < fine; ++y)
            for (int x = 0; x < fine; ++x) {
                const Point2f p{w.min.x + size.x * (float(x) + 0.5f) / fine,
                                w.min.y + size.y * (float(y) + 0.5f) / fine};
                expected[bin(p)] += double(d.PDF(p, w) * size.x * size.y) / (fine * fine) * samples;
            }
        EXPECT_GT(TestCounts(counts, expected).pValue, Sidak(0.01, int(windows.size())));
    }
    EXPECT_EQ(d.PDF({0.1f, 0.5f}, windows[1]), 0);
    EXPECT_FALSE(
        WindowedDistribution(std::vector<float>(4, 0.f), 2).Draw({0.5f, 0.5f}, windows[0]));
}

/// Irradiance at p of a light that is sampled, and what is seen of it.
struct Irradiance {
    double sampled, sigma, seen;
};
Irradiance Measure(const Light &light, Point3f p, Normal3f n) {
    Rng rng(3);
    constexpr int samples = 100000;
    double sum = 0, squares = 0;
    for (int i = 0; i < samples; ++i) {
        const auto s = SampleLi(light, {p, {}}, rng.Uniform2D(), kLambda);
        const double v = s ? double(Level(s->L) * std::max(0.f, Dot(n, s->wi)) / s->pdf) : 0;
        sum += v, squares += v * v;
    }
    const double mean = sum / samples;
    constexpr int m = 1024;
    double seen = 0;
    for (int y = 0; y < m; ++y)
        for (int x = 0; x < m; ++x) {
            const Vector3f w =
                EqualAreaSquareToSphere(Point2f{(float(x) + 0.5f) / m, (float(y) + 0.5f) / m});
            seen += double(Level(Le(light, Ray{p, w}, kLambda)) * std::max(0.f, Dot(n, w)));
        }
    return {mean, std::sqrt((squares / samples - mean * mean) / samples),
            seen * 4 * double(Pi) / (m * m)};
}

constexpr char kPortal[] = "\"point3 portal\" [ -1 -1 2  -1 1 2  1 1 2  1 -1 2 ]";

TEST_F(PictureLights, APortalsSamplesFindAllThatComesThroughIt) {
    Write(Uneven(32));
    const LightScene s = Scene(fmt::format(
        "Rotate 50 1 2 -1 LightSource \"infinite\" \"string filename\" \"p.exr\" {}", kPortal));
    for (const Point3f p :
         {Point3f{0, 0, 0}, Point3f{3, -1, 1.5f}, Point3f{0.5f, 0.5f, 1.9f}, Point3f{-8, 5, -9}}) {
        const Irradiance e = Measure(s.Only(), p, {0, 0, 1});
        // Quadrature of the window's edge.
        EXPECT_NEAR(e.sampled, e.seen, 4 * e.sigma + 5e-3 * e.seen) << p.x;
        EXPECT_GT(e.seen, 0);
        // Three times the samples' own spread would be that of directions drawn without the
        // picture.
        EXPECT_LT(e.sigma, 5e-3 * e.seen) << p.x;
    }
    // From outside nothing is seen.
    const Irradiance outside = Measure(s.Only(), {0, 0, 3}, {0, 0, -1});
    EXPECT_EQ(outside.sampled, 0);
    EXPECT_EQ(outside.seen, 0);
}

TEST_F(PictureLights, APortalShowsTheLightWithoutIt) {
    Write(Uneven(32));
    const std::string light =
        "Rotate 50 1 2 -1 LightSource \"infinite\" \"string filename\" \"p.exr\" \"float "
        "illuminance\" 4 ";
    const LightScene all = Scene(light), s = Scene(light + kPortal);
    Rng rng(5);
    int through = 0;
    for (int i = 0; i < 2000; ++i) {
        const Point3f p = 3.f * rng.Uniform() * SampleUniformSphere(rng.Uniform2D());
        const Ray ray{p, SampleUniformSphere(rng.Uniform2D())};
        const float t = (2 - p.z) / ray.d.z;
        const Point3f at = p + t * ray.d;
        const bool passes = p.z < 2 && ray.d.z > 0 && std::abs(at.x) <= 1 && std::abs(at.y) <= 1;
        through += passes;
        const SampledSpectrum want = passes ? Le(all.Only(), ray, kLambda) : SampledSpectrum(0);
        EXPECT_EQ(Le(s.Only(), ray, kLambda)[0], want[0]) << i;
    }
    EXPECT_GT(through, 50);
}

TEST_F(PictureLights, APortalOfASpectrumIsThatSpectrum) {
    const LightScene s = Scene(fmt::format(
        "LightSource \"infinite\" \"blackbody L\" 3000 \"float illuminance\" 7 {}", kPortal));
    const LightScene all =
        Scene("LightSource \"infinite\" \"blackbody L\" 3000 \"float illuminance\" 7");
    const Ray ray{{0, 0, 0}, {0, 0, 1}};
    for (int i = 0; i < NSpectrumSamples; ++i)
        EXPECT_NEAR(Le(s.Only(), ray, kLambda)[i], Le(all.Only(), ray, kLambda)[i],
                    1e-5f * Le(all.Only(), ray, kLambda)[i]);
}

TEST_F(PictureLights, PortalsAreRectangles) {
    const auto messages = [&](const std::string &points) {
        return Scene("LightSource \"infinite\" \"point3 portal\" [ " + points + " ]").Messages();
    };
    EXPECT_EQ(messages("0 0 0  1 0 0  1 1 0"), "l.pbrt:2:24: \"portal\" needs 4 points, not 3\n");
    for (const char *wrong : {"0 0 0  1 0 0  0 1 0  1 1 0", "0 0 0  1 0 0  1.2 1 0  0.2 1 0",
                              "0 0 0  1 0 0  2 1 0  0 1 0"})
        EXPECT_EQ(messages(wrong),
                  "l.pbrt:2:24: \"portal\" is no rectangle; its corners go around\n");
    EXPECT_EQ(messages("0 0 0  0 0 0  1 1 0  0 1 0"),
              "l.pbrt:2:24: \"portal\" has a side without length\n");
}

TEST_F(PictureLights, AnAreaLightShowsThePictureOverItsUV) {
    Image image = Filled({2, 2}, 0.5f);
    SetGray(&image, {0, 0}, 1);  // top left
    SetGray(&image, {1, 1}, 2);  // bottom right
    Write(image);
    BilinearMesh patch;
    patch.indices = {0, 1, 2, 3};
    patch.p = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}};
    patch.planar = true;
    const std::string file = fmt::format("\"diffuse\" \"string filename\" \"{}\" ", Path("p.exr"));
    const AreaScene s(file + "\"float scale\" 3", patch);
    ASSERT_EQ(s.Messages(), "");
    const auto seen = [&](float u, float v) {
        return Level(L(s.lights[0], {}, {0, 0, 1}, {u, v}, {0, 0, 1}, kLambda));
    };
    EXPECT_NEAR(seen(0.25f, 0.75f), 3, 3e-3);
    EXPECT_NEAR(seen(0.75f, 0.25f), 6, 6e-3);
    EXPECT_NEAR(seen(0.25f, 0.25f), 1.5, 3e-3);
    Rng rng(1);
    for (int i = 0; i < 100; ++i) {
        const auto sample = SampleLi(s.lights[0], {{0.5f, 0.5f, 2}, {}}, rng.Uniform2D(), kLambda);
        ASSERT_TRUE(sample);
        const Point3f p = sample->pLight;
        if (std::abs(p.x - 1) < 1e-4f || std::abs(p.y - 0.5f) < 1e-4f) continue;
        EXPECT_NEAR(Level(sample->L), seen(p.x / 2, p.y), 1e-4);
    }
    const AreaScene powered(file + "\"float power\" 9", patch);
    EXPECT_NEAR(Power(powered.lights[0]), 9, 1e-4);
    const AreaScene twice(file + "\"rgb L\" [ 1 1 1 ]", patch);
    EXPECT_NE(twice.Messages().find("both \"L\" and \"filename\""), std::string::npos);
}

TEST_F(PictureLights, ShapesShareThePictureOfTheirAreaLight) {
    Write(Uneven(4));
    const std::string file = fmt::format("\"diffuse\" \"string filename\" \"{}\" ", Path("p.exr"));
    LightPictures pictures;
    const AreaScene one(file, Rectangle(1, 1, 0), 1.f, &pictures);
    Put("p.exr", "no picture any more");
    const AreaScene other(file + "\"float scale\" 2", Rectangle(2, 1, 0), 1.f, &pictures);
    EXPECT_EQ(one.Messages() + other.Messages(), "");
    const auto picture = [](const AreaScene &s) {
        return std::get<DiffuseAreaLight>(s.lights.at(0)).surface->picture;
    };
    EXPECT_EQ(picture(one), picture(other));
}

TEST_F(PictureLights, BlackAreaLightsOfSomePowerAreWarnedOf) {
    Write(Filled({2, 2}, 0));
    const std::string file = fmt::format("\"diffuse\" \"string filename\" \"{}\" ", Path("p.exr"));
    EXPECT_EQ(AreaScene(file, Rectangle(1, 1, 0)).Messages(), "");
    EXPECT_NE(AreaScene(file + "\"float power\" 3", Rectangle(1, 1, 0)).Messages().find("is black"),
              std::string::npos);
}

TEST_F(PictureLights, WhatIsBlackOrTwiceGivenIsSaid) {
    Write(Filled({2, 2}, 0));
    for (const char *type : {"goniometric", "projection"})
        EXPECT_NE(
            Scene(fmt::format("LightSource \"{}\" \"string filename\" \"p.exr\" \"float power\" 3",
                              type))
                .Messages()
                .find("the picture is black"),
            std::string::npos);
    EXPECT_NE(Scene("LightSource \"goniometric\"").Messages(), "");
    Write(Filled({2, 1}, 1));
    EXPECT_NE(Scene("LightSource \"goniometric\" \"string filename\" \"p.exr\"")
                  .Messages()
                  .find("a goniometric light needs a square picture"),
              std::string::npos);
}

}  // namespace
}  // namespace pbrt::test
