#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/scene/entities.h"
#include "pbrt/scene/lexer.h"
#include "pbrt/scene/parameter_reader.h"
#include "pbrt/util/matrix.h"

namespace pbrt {

/// Reads the arguments of one directive after the other: names, numbers, matrices, parameters. A
/// wrong one is reported at its place, and the tokens up to the next directive are skipped.
class Arguments {
  public:
    Arguments(IsDirectiveName isDirective, Diagnostics *log)
        : isDirective(isDirective), log(log), parameters(isDirective, log) {}

    /// Sets the lexer that arguments are read from; nullptr: none.
    void ReadFrom(Lexer *from) { lexer = from; }
    Lexer *Source() const { return lexer; }
    /// A directive begins at the lexer's token. `name` must outlive the reading of its arguments.
    void Begin(std::string_view name) {
        directive = name;
        at = lexer->Loc();
        depth = 0;
    }

    /// The token not yet read, and its place.
    const Token &Peek() const { return lexer->Peek(); }
    FileLoc Loc() const { return lexer->Loc(); }
    void Advance() { lexer->Advance(); }
    bool IsDirective(const Token &t) const {
        return t.kind == TokenKind::Word && isDirective(t.text);
    }
    /// The directive's place.
    const FileLoc &At() const { return at; }

    std::optional<std::string> Name(std::string_view what);
    /// A plug-in's name in quotes and its parameters.
    std::optional<Entity> NamedEntity(std::string_view what, const RGBColorSpace *colorSpace);
    Entity EntityOfType(std::string type, const RGBColorSpace *colorSpace);
    ParsedParameters Parameters(const RGBColorSpace *colorSpace) {
        return parameters.Read(*lexer, colorSpace);
    }
    /// Reads as many numbers as there are labels, which name them in messages.
    std::optional<std::vector<float>> Numbers(std::span<const std::string_view> labels);
    /// 16 numbers in brackets, column after column.
    std::optional<Matrix4> BracketedMatrix();

    /// An error at the lexer's token: what was expected instead of it.
    void Expected(std::string_view what);
    /// An error about the directive.
    void Error(const FileLoc &loc, std::string_view message);
    /// Skips to the next directive, or the next line that begins with another name: a misspelt one.
    void Resynchronise();

  private:
    /// `describe()` says which number it is, for messages.
    template <typename Describe>
    bool NextNumber(float *value, Describe describe);

    IsDirectiveName isDirective;
    Diagnostics *log;
    ParameterReader parameters;
    Lexer *lexer = nullptr;
    std::string_view directive;  ///< being read
    FileLoc at;
    int depth = 0;  ///< open brackets at a failed argument
};

/// True where a word may be meant as a directive: it begins with a letter and is no boolean value.
bool MayBeDirective(std::string_view word);

}  // namespace pbrt
