// The short integrators against what is known, and against the path integrator.

#include <fmt/format.h>

#include "pbrt/integrators/integrators.h"
#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// Mean of `runs` images of different seeds and its standard error, in the green channel.
struct Estimate {
    double mean = 0, error = 0;
};
Estimate MeanOf(const std::string &text, int runs = 12) {
    double sum = 0, squares = 0;
    for (int seed = 0; seed < runs; ++seed) {
        const double mean = Mean(RenderText(text, {.seed = seed}))[1];
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / runs;
    return {mean, std::sqrt(std::max(squares / runs - mean * mean, 0.) / (runs - 1))};
}
/// Significance: 5 standard errors, estimated from a dozen runs each: some 1e-4.
void ExpectSame(const Estimate &a, const Estimate &b, const std::string &what) {
    EXPECT_NEAR(a.mean, b.mean, 5 * std::hypot(a.error, b.error) + 1e-6 * b.mean) << what;
    EXPECT_LT(a.error, 0.05 * a.mean) << what << ": too noisy to tell";
}

std::string Picture(const std::string &integrator, const std::string &world, int spp = 16) {
    return fmt::format(
        "LookAt 0 1.5 6  0 0.5 0  0 1 0\nCamera \"perspective\" \"float fov\" 35\n"
        "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 16\n"
        "Sampler \"independent\" \"integer pixelsamples\" {}\nIntegrator {}\nWorldBegin\n{}",
        spp, integrator, world);
}

constexpr char kFloorAndBall[] =
    "Material \"diffuse\" \"rgb reflectance\" [ .6 .6 .6 ]\n"
    "Shape \"trianglemesh\" \"point3 P\" [ -9 -1 -9  9 -1 -9  9 -1 9  -9 -1 9 ]\n"
    "  \"integer indices\" [ 0 1 2 0 2 3 ]\n"
    "Material \"diffuse\" \"rgb reflectance\" [ .7 .2 .1 ] Shape \"sphere\"\n";

/// Every kind of light, a rough and a smooth conductor, glass, a feather.
std::string Mixed() {
    return std::string(
               "LightSource \"infinite\" \"rgb L\" [ .5 .5 .5 ]\n"
               "LightSource \"distant\" \"point3 from\" [ 2 3 4 ] \"rgb L\" [ 2 2 2 ]\n"
               "LightSource \"point\" \"point3 from\" [ -2 3 2 ] \"rgb I\" [ 3 3 3 ]\n"
               "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 2 2 2 ]\n"
               "Translate 2 2 0 Shape \"sphere\" \"float radius\" .5 AttributeEnd\n") +
           kFloorAndBall +
           "AttributeBegin Translate 1.5 -.5 1 Material \"conductor\" \"float roughness\" .3\n"
           "Shape \"sphere\" \"float radius\" .5 AttributeEnd\n"
           "AttributeBegin Translate -1.5 -.5 1 Material \"featherbarbule\" \"float spacing\" 2\n"
           "Shape \"sphere\" \"float radius\" .5 AttributeEnd\n"
           "AttributeBegin Translate 0 -.6 1.5 Material \"dielectric\"\n"
           "Shape \"sphere\" \"float radius\" .4 AttributeEnd\n";
}

TEST(SimplePath, HasThePathIntegratorsMean) {
    const auto of = [](const std::string &integrator) {
        return MeanOf(Picture(integrator + " \"integer maxdepth\" 4", Mixed(), 64));
    };
    const Estimate path = of("\"path\"");
    ExpectSame(of("\"simplepath\""), path, "both");
    ExpectSame(of("\"path\" \"string lightsampler\" \"uniform\""), path, "path, uniform lights");
}

TEST(SimplePath, EveryWayToSampleHasTheSameMean) {
    // Only lights that directions find.
    const std::string world =
        "LightSource \"infinite\" \"rgb L\" [ .5 .5 .5 ]\n"
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 2 2 2 ]\n"
        "Translate 2 2 0 Shape \"sphere\" AttributeEnd\n" +
        std::string(kFloorAndBall) +
        "AttributeBegin Translate 1.5 -.5 1 Material \"diffusetransmission\"\n"
        "Shape \"sphere\" \"float radius\" .5 AttributeEnd\n";
    const Estimate path = MeanOf(Picture("\"path\" \"integer maxdepth\" 3", world, 64));
    for (const char *const lights : {"true", "false"})
        for (const char *const bsdf : {"true", "false"})
            ExpectSame(MeanOf(Picture(fmt::format("\"simplepath\" \"integer maxdepth\" 3 \"bool "
                                                  "samplelights\" {} \"bool samplebsdf\" {}",
                                                  lights, bsdf),
                                      world, 64)),
                       path, fmt::format("samplelights {}, samplebsdf {}", lights, bsdf));
    ExpectSame(MeanOf(Picture("\"randomwalk\" \"integer maxdepth\" 3", world, 64)), path,
               "randomwalk");
}

TEST(ShortIntegrators, StopAtMaxDepth) {
    // Depth 0 is what the camera sees shine; depth 1 adds one reflection.
    const std::string world =
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 1 1 1 ] Translate 0 .5 2\n"
        "Shape \"sphere\" \"float radius\" .4 AttributeEnd\n" +
        std::string(kFloorAndBall);
    for (const char *const name : {"simplepath", "randomwalk"})
        for (int depth = 0; depth <= 2; ++depth) {
            const auto with = [&](const char *integrator) {
                return MeanOf(Picture(
                    fmt::format("\"{}\" \"integer maxdepth\" {}", integrator, depth), world, 32));
            };
            ExpectSame(with(name), with("path"), fmt::format("{} {}", name, depth));
        }
}

TEST(ShortIntegrators, GapsAreNoBounce) {
    // A lamp behind two curtains of barbules; all light comes straight through.
    const std::string lamp =
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 1 1 1 ] \"bool twosided\" true\n"
        "Shape \"bilinearmesh\" \"point3 P\" [ -9 -9 -2  -9 9 -2  9 -9 -2  9 9 -2 ] AttributeEnd\n"
        "Material \"featherbarbule\" \"float spacing\" 4\n"
        "Shape \"bilinearmesh\" \"point3 P\" [ -9 -9 0  -9 9 0  9 -9 0  9 9 0 ]\n"
        "Shape \"bilinearmesh\" \"point3 P\" [ -9 -9 1  -9 9 1  9 -9 1  9 9 1 ]\n";
    const Estimate path = MeanOf(Picture("\"path\" \"integer maxdepth\" 1", lamp, 64));
    ExpectSame(MeanOf(Picture("\"simplepath\" \"integer maxdepth\" 1", lamp, 64)), path, "gaps");
}

TEST(AmbientOcclusion, IsTheShareOfTheOpenHemisphere) {
    // The camera looks down onto the middle of a floor between two long walls of height 2 at
    // distance 1. The cosine-weighted share of directions between them is the sine of the angle
    // between the normal and a wall's upper edge.
    const auto text = [](const std::string &more) {
        return "LookAt 0 5 0  0 0 0  0 0 1\nCamera \"orthographic\" \"float screenwindow\" [ "
               "-.001 .001 -.001 .001 ]\nFilm \"rgb\" \"integer xresolution\" 4 \"integer "
               "yresolution\" 4\nSampler \"zsobol\" \"integer pixelsamples\" 1024\nIntegrator "
               "\"ambientocclusion\"" +
               more +
               "\nWorldBegin\n"
               "Shape \"bilinearmesh\" \"point3 P\" [ -1 0 -500  1 0 -500  -1 0 500  1 0 500 ]\n"
               "Shape \"bilinearmesh\" \"point3 P\" [ -1 0 -500  -1 2 -500  -1 0 500  -1 2 500 ]\n"
               "Shape \"bilinearmesh\" \"point3 P\" [ 1 0 -500  1 2 -500  1 0 500  1 2 500 ]\n";
    };
    const double open = 1 / std::sqrt(5.);
    // 16384 samples of 0 or 1 have a standard error of .004, these much less.
    for (const char *const more : {"", " \"bool cossample\" false"})
        EXPECT_NEAR(Mean(RenderText(text(more)))[1], open, 0.012) << more;
    EXPECT_NEAR(Mean(RenderText(text(" \"float maxdistance\" .5")))[1], 1, 1e-3);
    // Within distance 1.25 each wall occludes directions of angle from its foot up to where it is
    // 1.25 away, or, along the wall, farther: some, but not all.
    const double near = Mean(RenderText(text(" \"float maxdistance\" 1.25")))[1];
    EXPECT_GT(near, open + 0.05);
    EXPECT_LT(near, 0.95);
}

TEST(AmbientOcclusion, NeedsNoLightAndWarnsOfNone) {
    const auto warnings = [](const std::string &integrator) {
        Diagnostics log;
        SceneDescription description;
        ParseString(Picture(integrator, kFloorAndBall), "test.pbrt", ".", description, log);
        EXPECT_TRUE(MakeRenderTask(std::move(description), {}, log));
        return log.Messages().size();
    };
    EXPECT_EQ(warnings("\"ambientocclusion\""), 0u);
    EXPECT_EQ(warnings("\"volpath\""), 1u);
    EXPECT_EQ(warnings("\"randomwalk\""), 1u);
}

TEST(ShortIntegrators, ForcedDiffuseIsThatOfPath) {
    const std::string world =
        "LightSource \"infinite\" \"rgb L\" [ .5 .5 .5 ]\n"
        "Material \"conductor\" Shape \"sphere\"\n";
    const auto of = [&](const char *integrator) {
        return MeanOf("Option \"forcediffuse\" true\n" +
                      Picture(fmt::format("\"{}\" \"integer maxdepth\" 2", integrator), world, 32));
    };
    ExpectSame(of("simplepath"), of("path"), "simplepath");
    ExpectSame(of("randomwalk"), of("path"), "randomwalk");
}

TEST(EveryIntegrator, TheSameBitsForAnyNumberOfThreads) {
    for (const std::string_view name : IntegratorTypes::kNames) {
        const std::string text = Picture(fmt::format("\"{}\"", name), Mixed());
        EXPECT_EQ(RenderText(text, {.nThreads = 1}).Data(),
                  RenderText(text, {.nThreads = 2}).Data())
            << name;
    }
}

}  // namespace
}  // namespace pbrt::test
