#pragma once

#include <span>
#include <string_view>

namespace pbrt {

/// Vector of ParsedParameter that holds a type's values.
enum class ValueKind { Float, Int, Bool, String, FloatOrString };

/// One parameter type of the scene language (PBRT_FORMAT 1.2).
struct ParamType {
    std::string_view name;
    ValueKind kind;
    int items;  ///< tokens that make one value
};

/// nullptr where there is no such type.
const ParamType *FindParamType(std::string_view name);
std::span<const std::string_view> ParamTypeNames();
/// pbrt-v4's name of a type of pbrt-v3 ("color": "rgb"), or of a likely slip ("int": "integer");
/// empty where `name` is neither.
std::string_view NewNameOfType(std::string_view name);

/// A parameter declaration `type name` taken apart; empty where a part is missing.
struct Declaration {
    std::string_view type, name;
};
Declaration SplitDeclaration(std::string_view text);

}  // namespace pbrt
