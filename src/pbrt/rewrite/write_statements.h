#pragma once

#include <string>
#include <vector>

#include "pbrt/rewrite/statement.h"

namespace pbrt::rewrite {

/// Sets statements as text: blocks indented by four columns, a parameter a line, at most one empty
/// line in a row, long lists broken at column 100. Numbers and strings stay as they are written.
class StatementWriter {
  public:
    void Write(const Statement &s);
    const std::string &Text() const { return text; }

  private:
    void EmptyLine();
    void Comments(const std::vector<std::string> &comments, int indent);
    void Parameters(const Statement &s);
    /// The words in a line that begins in column `indent`, broken where it grows too long.
    void Line(const std::vector<std::string> &words, int indent, const std::string &remark);

    std::string text;
    int indent = 0;
};

}  // namespace pbrt::rewrite
