#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "pbrt/scene/params.h"

// The manual of the scene language, asked of the plug-ins themselves: each is created without
// parameters, and what it asked for is its table. So no text can differ from what a scene may say.
namespace pbrt::reference {

/// A family of plug-ins, called as messages call it: "film", "area light".
struct Family {
    std::string_view name;
    std::string_view directive;  ///< how a scene names one of them, after which parameters follow
    std::vector<std::string_view> (*types)();
    /// Creates one and drops it; what is wrong goes to the parameters' diagnostics.
    void (*create)(std::string_view type, ParamDict &params);
};

/// All of them, in the order in which a scene file has them.
std::span<const Family> Families();

/// Parameters and messages that creating a plug-in asked for and gave.
struct Trial {
    std::vector<RequestedParam> requested;
    std::vector<Message> messages;
};
/// Creates a plug-in of one of the family's types with these parameters.
Trial Create(const Family &family, std::string_view type, ParsedParameters params);

/// Every parameter of a plug-in: what it asks for without any, then what it asks for where a choice
/// has another value than its default.
std::vector<RequestedParam> ParametersOf(const Family &family, std::string_view type);

}  // namespace pbrt::reference
