#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/rewrite/statement.h"

namespace pbrt::rewrite {

/// Turns pbrt-v3's names and parameters into pbrt-v4's, as its `--upgrade` does (PBRT_FORMAT 3.1);
/// old names come from the table of util/upstream.h. What pbrt-v4 has no word for is left out with
/// a warning, or, where the picture would be another, an error. Defaults that changed from v3 to v4
/// are not written out. What is v4 already stays.
class Upgrade {
  public:
    explicit Upgrade(Diagnostics *log) : log(log), scopes(1) {}

    void Apply(Statement *s);

  private:
    /// Names that this scope and those around it have defined, and what they are called now:
    /// pbrt-v4 lets none be defined twice. Objects' names know no scopes.
    struct Scope {
        std::map<std::string, std::string> names;  ///< by kind and name: "material x"
        bool isTransform = false;                  ///< of TransformBegin: ends with no name
    };

    void OpenOrClose(Statement *s);
    void WarnOfLeak(const Statement &s);
    void RenamePlugIn(Statement *s);
    void RenameParameters(Statement *s);
    /// The argument is a name being defined; one that is taken gets another.
    void Define(std::string_view kind, Statement *s);
    /// The new name of what is written as `quoted`.
    std::string Current(std::string_view kind, const std::string &quoted) const;
    void RenameUsed(Statement *s);

    Diagnostics *log;
    std::vector<Scope> scopes;
    std::set<std::string> defined;  ///< all there ever were, as in Scope::names
};

}  // namespace pbrt::rewrite
