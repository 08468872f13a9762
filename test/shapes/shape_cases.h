#pragma once

#include <array>
#include <string>
#include <vector>

#include "shapes/make.h"
#include "support/every_type.h"

namespace pbrt {

/// A shape, and the text it is made from.
struct ShapeCase {
    std::string text;
    Shape shape;
};

/// Where examples are placed. Curves refuse to be stretched.
inline constexpr std::array<std::string_view, 4> kPlaces{
    "", "ReverseOrientation Scale 1 1 -1", "Translate 1 0 0 Rotate 30 1 2 0 Scale 1.5 1.5 1.5",
    "Rotate 40 1 0 1 Scale 1 1.5 -0.5"};

/// The shapes of type S on which every law is tested: its examples, placed in several ways.
template <typename S>
std::vector<ShapeCase> CasesOf() {
    std::vector<ShapeCase> cases;
    for (const std::string_view example : S::kExamples)
        for (const std::string_view place : kPlaces) {
            const std::string text = std::string(place) + " Shape \"" + std::string(S::kName) +
                                     "\" " + std::string(example);
            Made made = Make(text);
            const bool isRefused = place == kPlaces.back() && made.shapes.empty();
            if (isRefused) continue;
            EXPECT_EQ(made.messages, Texts{}) << text;
            EXPECT_EQ(made.shapes.size(), 1u) << text;
            for (Shape &shape : made.shapes)
                cases.push_back({text, std::move(shape)});
        }
    return cases;
}

/// Of all types.
inline std::vector<ShapeCase> AllCases() {
    std::vector<ShapeCase> all;
    ShapeTypes::ForEach([&]<typename S>() {
        for (ShapeCase &c : CasesOf<S>())
            all.push_back(std::move(c));
    });
    return all;
}

}  // namespace pbrt
