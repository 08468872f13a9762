#pragma once

#include "pbrt/scene/lexer.h"
#include "pbrt/scene/param_types.h"
#include "pbrt/scene/params.h"

namespace pbrt {

/// Tells whether a word is a directive's name.
using IsDirectiveName = bool (*)(std::string_view word);

/// Reads parameter lists: `"type name" value` or `"type name" [ values ]`, repeated.
class ParameterReader {
  public:
    /// A directive's name ends a list.
    ParameterReader(IsDirectiveName isDirective, Diagnostics *log)
        : isDirective(isDirective), log(log) {}

    /// The list that starts at the lexer's token; stops at the first token that cannot belong to
    /// it. Every mistake is reported; the parameter then has no values, which the getters of
    /// ParamDict know as "given, but already reported".
    ParsedParameters Read(Lexer &lexer, const RGBColorSpace *colorSpace);

  private:
    template <typename Number>
    struct NumberSyntax {
        std::string_view what;
        std::optional<Number> (*parse)(std::string_view text);
        std::string (*whyNot)(std::string_view text);
    };

    void ReadOne(Lexer &lexer, const RGBColorSpace *colorSpace);
    /// Returns the type that was probably meant, if any: the parameter then counts as given. Of a
    /// type of pbrt-v3 only the first use is reported.
    const ParamType *ReportUnknownType(const Declaration &d, const FileLoc &loc);
    // True where the values are right; they are then in the buffers below. A wrong one is reported
    // and left to the caller to skip.
    bool ReadValues(Lexer &lexer, const ParamType &type, FileLoc *first);
    bool ReadList(Lexer &lexer, const ParamType &type);
    bool ReadValue(Lexer &lexer, const ParamType &type);
    bool ReadString(Lexer &lexer);
    template <typename Number>
    bool ReadNumber(Lexer &lexer, const NumberSyntax<Number> &syntax, std::vector<Number> *values);
    bool ReadBool(Lexer &lexer);
    bool IsLast(Lexer &lexer);
    void KeepValues(ParsedParameter *p);
    /// Past the values of a parameter that cannot be read; nothing is reported.
    void SkipValues(Lexer &lexer);
    void SkipList(Lexer &lexer);
    bool IsDirective(const Token &t) const {
        return t.kind == TokenKind::Word && isDirective(t.text);
    }
    /// True where the token cannot be part of the parameter before it.
    bool EndsParameter(const Token &t) const;
    /// An error about the parameter being read; returns false.
    bool Fail(const FileLoc &loc, std::string_view message);
    bool Expected(Lexer &lexer, std::string_view what);

    IsDirectiveName isDirective;
    Diagnostics *log;
    std::string_view declaration;  ///< of the parameter being read, as written
    bool inList = false;
    // Kept between calls, so that each parameter is one allocation of the right size.
    ParsedParameters parameters;
    std::vector<float> floats;
    std::vector<int> ints;
    std::vector<std::string> strings;
    std::vector<uint8_t> bools;
};

}  // namespace pbrt
