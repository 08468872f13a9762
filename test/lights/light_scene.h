#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "pbrt/lights/lights.h"
#include "pbrt/scene/description.h"

namespace pbrt::test {

/// A spectrum of the same value at all wavelengths: a light's luminance is its value times this.
inline constexpr float kLuminance = CIE_Y_integral;
inline const std::string kFlat = "[ 300 1 900 1 ]";
inline const SampledWavelengths kLambda = SampledWavelengths::SampleVisible(0.4f);

/// The lights of a scene whose world block is `world`, in a scene of radius `radius` about 0.
struct LightScene {
    explicit LightScene(const std::string &world, const std::string &dir = "", float radius = 10) {
        ParseString("WorldBegin\n" + world, "l.pbrt", dir, scene, log);
        const float half = radius / std::sqrt(3.f);
        for (const LightEntity &entity : scene.lights) {
            ParamDict params(entity.params, entity.loc, "light \"" + entity.type + "\"",
                             entity.colorSpace, &log, dir);
            if (auto light = CreateLight(entity.type, params, entity.worldFromLight)) {
                Preprocess(*light, {{-half, -half, -half}, {half, half, half}});
                lights.push_back(*light);
            }
        }
    }
    std::string Messages() const {
        std::string all;
        for (const Message &m : log.Messages())
            all += m.text + "\n";
        return all;
    }
    const Light &Only() const {
        EXPECT_EQ(Messages(), "");
        EXPECT_EQ(lights.size(), 1u);
        return lights.at(0);
    }

    SceneDescription scene;
    Diagnostics log;
    std::vector<Light> lights;
};

/// Area lights of `AreaLightSource "diffuse" params` on a shape.
struct AreaScene {
    AreaScene(const std::string &params, Shape shapeGiven, FloatTexture alpha = 1.f,
              LightPictures *pictures = nullptr)
        : shape(std::move(shapeGiven)) {
        ParseString("WorldBegin\nAreaLightSource " + params + "\nShape \"sphere\"", "l.pbrt", "",
                    scene, log);
        const Entity &entity = *scene.shapes.begin()->areaLight;
        ParamDict dict(entity.params, entity.loc, "area light \"" + entity.type + "\"",
                       entity.colorSpace, &log);
        lights = CreateAreaLights(entity.type, dict, {shape, alpha, nullptr, pictures});
    }
    std::string Messages() const {
        std::string all;
        for (const Message &m : log.Messages())
            all += m.text + "\n";
        return all;
    }

    SceneDescription scene;
    Diagnostics log;
    Shape shape;
    std::vector<Light> lights;
};

/// A rectangle of two triangles in z = height, normals up (+z).
inline Shape Rectangle(float width, float depth, float height) {
    TriangleMesh mesh;
    const float x = width / 2, y = depth / 2;
    mesh.p = {{-x, -y, height}, {x, -y, height}, {x, y, height}, {-x, y, height}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

inline Vector3f UniformDirection(std::mt19937 &rng) {
    std::uniform_real_distribution<float> u(0, 1);
    const float z = 1 - 2 * u(rng), phi = 2 * Pi * u(rng), r = SafeSqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}
inline Point2f UniformSquare(std::mt19937 &rng) {
    std::uniform_real_distribution<float> u(0, OneMinusEpsilon);
    const float x = u(rng);
    return {x, u(rng)};
}

}  // namespace pbrt::test
