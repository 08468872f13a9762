#pragma once

#include <memory>
#include <string>
#include <vector>

#include "materials/material_text.h"

namespace pbrt::test {

/// One of a material type's examples, made as the renderer makes it.
struct MaterialExample {
    std::string text;
    std::shared_ptr<const MaterialText> made;  ///< BxDFs may point into it
};

/// All examples of M. Each must be read without a message.
template <MaterialType M>
std::vector<MaterialExample> MaterialExamples() {
    std::vector<MaterialExample> examples;
    for (const std::string_view parameters : M::kExamples) {
        std::string text = "Material \"";
        text += M::kName;
        text += "\" ";
        text += parameters;
        auto made = std::make_shared<const MaterialText>(text);
        EXPECT_EQ(made->Messages(), "") << text;
        examples.push_back({text, made});
    }
    return examples;
}

/// The example's BxDF at the middle of its textures.
template <MaterialType M>
BxDFOf<M> BxDFAt(const MaterialExample &example) {
    SampledWavelengths lambda = SampledWavelengths::Of({430, 510, 590, 670});
    return std::get<M>(*example.made->material).GetBxDF(AtUV(0.5f, 0.5f), lambda);
}

}  // namespace pbrt::test
