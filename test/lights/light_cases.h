#pragma once

#include <unistd.h>

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

/// A folder with that picture, "sky.exr".
class SkyFolder {
  public:
    SkyFolder()
        : folder(std::filesystem::path(testing::TempDir()) /
                 ("pbrt-sky-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder);
        EXPECT_EQ(WriteImage(ExampleSky(), (folder / "sky.exr").string(), ExrPixels::Float),
                  std::nullopt);
    }
    ~SkyFolder() { std::filesystem::remove_all(folder); }
    std::string Name() const { return folder.string(); }

  private:
    std::filesystem::path folder;
};

/// Radius of the scene that all examples stand in, about 0.
inline constexpr float kSceneRadius = 10;

/// The lights of type L on which every law is tested: those of its kExamples, which it must have.
template <typename L>
std::vector<LightCase> CasesOf() {
    const SkyFolder folder;
    std::vector<LightCase> cases;
    for (const std::string_view text : L::kExamples) {
        const auto parsed = ParseWorld(text, folder.Name());
        const auto params = [&](const Entity &entity, const char *kind) {
            return ParamDict(entity.params, entity.loc, std::string(kind) + entity.type,
                             entity.colorSpace, &parsed->log, folder.Name());
        };
        if constexpr (L::kTraits.isArea) {
            const ShapeEntity entity = *parsed->scene.shapes.begin();
            ParamDict shapeParams = params(entity, "shape "), own = params(*entity.areaLight, "");
            const float alpha = shapeParams.GetOneFloat("alpha", 1);
            for (Shape &shape : CreateShapes(entity, shapeParams, entity.worldFromObject[0])) {
                const auto kept = std::make_shared<const Shape>(std::move(shape));
                for (const Light &light :
                     CreateAreaLights(entity.areaLight->type, own, *kept, alpha))
                    cases.push_back({std::string(text), kept, light});
            }
        } else {
            for (const LightEntity &entity : parsed->scene.lights) {
                ParamDict own = params(entity, "light ");
                if (auto light = CreateLight(entity.type, own, entity.worldFromLight))
                    cases.push_back({std::string(text), nullptr, *light});
            }
        }
        EXPECT_EQ(parsed->Messages(), Texts{}) << text;
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
