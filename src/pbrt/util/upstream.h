#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pbrt {

/// A name that pbrt-v4 knows (docs/PBRT_FORMAT.md) and nothing here answers to, unless a plug-in of
/// that name has been added since: then the row has no effect and may go.
struct UpstreamName {
    std::string_view kind;     ///< as in messages; parameters: whose, as in `material "diffuse"`
    std::string_view name;     ///< of options the letters and digits alone
    std::string_view instead;  ///< what does nearly the same here; empty: nothing does
};

std::span<const UpstreamName> NotBuiltHere();

/// For messages about unknown names: `; pbrt-v4 has it, not built here; use "x"`, or nothing where
/// pbrt-v4 has no such name either.
std::string PbrtHasIt(std::string_view kind, std::string_view name);

}  // namespace pbrt
