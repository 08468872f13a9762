#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pbrt/samplers/samplers.h"
#include "pbrt/scene/description.h"

namespace pbrt {

/// The examples of all samplers, each read without a message; `seed` where they give none. At most
/// 64 samples per pixel, but for examples that ask for more.
inline std::vector<Sampler> SamplerExamples(Point2i resolution, int seed) {
    std::vector<Sampler> samplers;
    SamplerTypes::ForEach([&]<typename S>() {
        for (const std::string_view example : S::kExamples) {
            Diagnostics log;
            SceneDescription scene;
            const std::string text = fmt::format("Sampler \"{}\" {} WorldBegin", S::kName, example);
            ParseString(text, "test.pbrt", "", scene, log);
            ParamDict params(scene.sampler.params, {}, "sampler", nullptr, &log);
            const auto sampler = CreateSampler(params, S::kName, {}, seed, resolution);
            EXPECT_TRUE(log.Messages().empty()) << text;
            if (sampler) samplers.push_back(*sampler);
        }
    });
    return samplers;
}

}  // namespace pbrt
