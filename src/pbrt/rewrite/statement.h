#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/util/diagnostics.h"

namespace pbrt::rewrite {

/// A parameter as it stands in a scene file: `"type name" [ values ]`.
struct Parameter {
    std::string type, name;
    std::vector<std::string> values;  ///< one at least, as written, strings with their quotes
    FileLoc loc;
    std::vector<std::string> comments;  ///< `# ...`, those above it and between its values
    std::string remark;                 ///< the comment behind it on its last line, or empty
};

/// A directive with all that belongs to it, nothing interpreted.
struct Statement {
    std::string directive;  ///< empty: comments alone
    FileLoc loc;
    std::vector<std::string> arguments;  ///< before the parameters, as written; brackets too
    std::vector<Parameter> parameters;
    std::vector<std::string> comments;  ///< above it; an empty one is an empty line
    std::string remark;                 ///< the comment behind directive and arguments, or empty

    /// The last of this name, or nullptr.
    Parameter *Find(std::string_view name);
    /// All of this name; those that are gone leave their comments above the statement.
    void Remove(std::string_view name);
    /// Puts it in front of the others.
    void Add(std::string type, std::string name, std::vector<std::string> values);
};

std::string Quoted(std::string_view name);
/// The text between the quotes of `written`; without quotes, the whole.
std::string Unquoted(std::string_view written);
/// The values as numbers; nullopt where one is none.
std::optional<std::vector<float>> Numbers(const Parameter &p);

}  // namespace pbrt::rewrite
