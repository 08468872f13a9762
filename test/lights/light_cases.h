#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lights/light_scene.h"
#include "pbrt/image/image.h"
#include "scene/parse.h"
#include "support/every_type.h"

namespace pbrt::test {

/// A light of type L with all that it stands on, and the text it is made from.
struct LightCase {
    std::string text;
    std::shared_ptr<const Shape> shape;  ///< of area lights
    Light light;
};

/// Grey with a ramp and a few bright pixels.
inline Image ExampleSky() {
    constexpr int n = 16;
    Image image({n, n}, {"R", "G", "B"});
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            for (int c = 0; c < 3; ++c)
                image.Set({x, y}, c, 0.5f + float(x) / n + ((5 * x + 3 * y) % 23 == 0 ? 20 : 0));
    return image;
}

/// A folder with that picture, "example.exr".
class SkyFolder {
  public:
    SkyFolder()
        : folder(std::filesystem::path(testing::TempDir()) /
                 ("pbrt-sky-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder);
        EXPECT_EQ(WriteImage(ExampleSky(), (folder / "example.exr").string(), ExrPixels::Float),
                  std::nullopt);
    }
    ~SkyFolder() { std::filesystem::remove_all(folder); }
    std::string Name() const { return folder.string(); }

  private:
    std::filesystem::path folder;
};

/// Radius of the scene that all examples stand in, about 0.
inline constexpr float kSceneRadius = 10;

/// What area lights stand on.
inline constexpr std::array<std::string_view, 5> kEmitters{
    R"(Shape "bilinearmesh" "point3 P" [ 0 0 0  2 0 0  0 1 0  2 1 0 ])",
    R"(Translate 2 0 4 Shape "sphere")",
    R"(ReverseOrientation Shape "trianglemesh" "point3 P" [ 0 0 0  2 0 0.5  0.3 1 0 ])",
    R"(Shape "disk" "float alpha" 0.4)", R"(Shape "disk" "float alpha" 0)"};
/// Where the others stand.
inline constexpr std::array<std::string_view, 2> kLightPlaces{
    "", "Translate 0 0 1 Rotate 50 1 2 -1 Scale 1 2 0.5"};

namespace detail {

inline ParamDict Params(const Entity &entity, std::string kind, const std::string &dir,
                        Diagnostics *log) {
    return ParamDict(entity.params, entity.loc, kind + entity.type, entity.colorSpace, log, dir);
}

/// The area lights of a text with one shape.
inline void AddAreaLights(const std::string &text, const std::string &dir, Parsed &parsed,
                          std::vector<LightCase> *cases) {
    static constexpr FloatParam kAlpha{"alpha", "", 1, 0, 1, "coverage"};
    const ShapeEntity entity = *parsed.scene.shapes.begin();
    ParamDict shapeParams = Params(entity, "shape ", "", &parsed.log);
    ParamDict own = Params(*entity.areaLight, "area light ", dir, &parsed.log);
    const float alpha = shapeParams.GetOneFloat(kAlpha);
    for (Shape &shape : CreateShapes(entity, shapeParams, entity.worldFromObject[0])) {
        const auto kept = std::make_shared<const Shape>(std::move(shape));
        for (const Light &light : CreateAreaLights(entity.areaLight->type, own, {*kept, alpha}))
            cases->push_back({text, kept, light});
    }
}

/// The lights of a text, other than area lights.
inline void AddLights(const std::string &text, const std::string &dir, Parsed &parsed,
                      std::vector<LightCase> *cases) {
    for (const LightEntity &entity : parsed.scene.lights) {
        ParamDict own = Params(entity, "light ", dir, &parsed.log);
        if (auto light = CreateLight(entity.type, own, entity.worldFromLight))
            cases->push_back({text, nullptr, *light});
    }
}

}  // namespace detail

/// The lights of type L on which every law is tested: its examples, each in several places.
template <typename L>
std::vector<LightCase> CasesOf() {
    const SkyFolder folder;
    std::vector<LightCase> cases;
    const auto add = [&](const std::string &text) {
        const auto parsed = ParseWorld(text, folder.Name());
        const size_t before = cases.size();
        if (L::kTraits.isArea)
            detail::AddAreaLights(text, folder.Name(), *parsed, &cases);
        else
            detail::AddLights(text, folder.Name(), *parsed, &cases);
        EXPECT_EQ(parsed->Messages(), Texts{}) << text;
        EXPECT_GT(cases.size(), before) << text;
    };
    for (const std::string_view example : L::kExamples) {
        if (L::kTraits.isArea)
            for (const std::string_view emitter : kEmitters)
                add(fmt::format("AreaLightSource \"{}\" {} {}", L::kName, example, emitter));
        else
            for (const std::string_view place : kLightPlaces)
                add(fmt::format("{} LightSource \"{}\" {}", place, L::kName, example));
    }
    const float half = kSceneRadius / std::sqrt(3.f);
    for (LightCase &c : cases)
        Preprocess(c.light, {{-half, -half, -half}, {half, half, half}});
    return cases;
}

/// Of all types.
inline std::vector<LightCase> AllCases() {
    std::vector<LightCase> all;
    LightTypes::ForEach([&]<typename L>() {
        for (LightCase &c : CasesOf<L>())
            all.push_back(std::move(c));
    });
    return all;
}

}  // namespace pbrt::test
