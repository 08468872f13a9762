#pragma once

#include <string>

#include "pbrt/build/render_scene.h"
#include "pbrt/lights/light_sampler.h"

namespace pbrt {

/// Which of the two ways to find light a path uses. Both together is what renders; one alone is for
/// tests and measurements: all three have the same mean (but for lights that one cannot find).
enum class LightStrategy { Both, LightsOnly, BSDFOnly };

/// What the path integrator is told, and what it makes of the scene's lights.
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
