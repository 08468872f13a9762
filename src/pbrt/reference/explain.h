#pragma once

#include <string>
#include <string_view>

namespace pbrt::reference {

struct Explanation {
    std::string text;   ///< whole lines
    std::string error;  ///< a sentence, where there is nothing to explain; `text` is empty then
};

/// `what` is
///   a family, as "material": the names of its types, one a line;
///   a plug-in, as `material "diffuse"` (the quotes may be left out): its parameters, with type,
///     unit, default, range and meaning;
///   "option": the `Option` directives;
///   "all": docs/REFERENCE.md.
Explanation Explain(std::string_view what);

}  // namespace pbrt::reference
