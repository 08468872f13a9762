#pragma once

#include <string>

#include "pbrt/build/render_scene.h"
#include "pbrt/lights/light_sampler.h"

namespace pbrt {

/// The two ways in which a path finds light. The renderer uses both together; one alone is for
/// tests and measurements: all three have the same mean (but for lights that one cannot find).
enum class LightStrategy { Both, LightsOnly, BSDFOnly };

/// Parameters of the path integrator, and the light sampler that it makes of the scene's lights.
struct PathSettings {
    int maxDepth = 5;
    bool regularize = false;
    LightStrategy strategy = LightStrategy::Both;
    std::string lightSamplerName = "bvh";  ///< one of kLightSamplerNames
    LightSampler lightSampler;

    void Preprocess(const RenderScene &scene) {
        lightSampler = LightSampler::Create(lightSamplerName, scene.lights);
    }
};

}  // namespace pbrt
