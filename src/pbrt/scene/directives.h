#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "pbrt/scene/directive_context.h"

namespace pbrt {

/// Part of a scene file in which a directive may stand.
enum class Where : uint8_t { Anywhere, BeforeWorld, InWorld };

struct Directive {
    std::string_view name;
    Where where;
    /// Reads the arguments that follow and hands them to the builder.
    void (*read)(DirectiveContext &context);
};

/// nullptr where there is no such directive.
const Directive *FindDirective(std::string_view name);
std::span<const std::string_view> DirectiveNames();
/// For a directive of pbrt-v3 that v4 has not: what to do about it; else empty.
std::string OldDirectiveHint(std::string_view name);

}  // namespace pbrt
