#pragma once

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

/// The shapes of type S on which every law is tested: those of its kExamples, which it must have.
template <typename S>
std::vector<ShapeCase> CasesOf() {
    std::vector<ShapeCase> cases;
    for (const std::string_view text : S::kExamples)
        cases.push_back({std::string(text), MakeOne(text)});
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
