#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/rewrite/statement.h"
#include "pbrt/scene/lexer.h"

namespace pbrt::rewrite {

/// Splits a scene file into statements. It knows how directives are built, those of pbrt-v3 too,
/// and not what plug-ins there are; files of Include are not read.
class StatementReader {
  public:
    /// `text` and `file` must outlive the reader and its statements.
    StatementReader(std::string_view text, std::string_view file, Diagnostics *log);

    /// nullopt at the end, and after the first mistake, which is reported.
    std::optional<Statement> Next();

  private:
    bool ReadArguments(Statement *s);
    bool ReadNames(int count, Statement *s);
    bool ReadParameters(Statement *s);
    bool ReadValues(Parameter *p);
    void Advance();
    /// Splits what stands before the token into `remark` and `lines`.
    void ReadGap();
    /// The comments before the token, behind `above`.
    void TakeComments(std::vector<std::string> *above, bool withEmptyLines);
    std::string TakeRemark();
    bool Expected(std::string_view what);

    Lexer lexer;
    Diagnostics *log;
    std::string remark;              ///< comment on the line of the token consumed last
    std::vector<std::string> lines;  ///< comments below it; an empty one is an empty line
};

}  // namespace pbrt::rewrite
