#include "pbrt/rewrite/read_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "pbrt/scene/arguments.h"
#include "pbrt/scene/directives.h"
#include "pbrt/scene/param_types.h"
#include "pbrt/util/upstream.h"

namespace pbrt::rewrite {
namespace {

struct Form {
    std::string_view directive;
    int names;  ///< quoted ones before the parameters
};
/// Directives that take parameters.
constexpr std::array kWithParameters{
    Form{"Accelerator", 1},
    Form{"AreaLightSource", 1},
    Form{"Attribute", 1},
    Form{"Camera", 1},
    Form{"Film", 1},
    Form{"Integrator", 1},
    Form{"LightSource", 1},
    Form{"MakeNamedMaterial", 1},
    Form{"MakeNamedMedium", 1},
    Form{"Material", 1},
    Form{"PixelFilter", 1},
    Form{"Sampler", 1},
    Form{"Shape", 1},
    Form{"Texture", 3},
    // pbrt-v2 and older.
    Form{"Renderer", 1},
    Form{"SurfaceIntegrator", 1},
    Form{"Volume", 1},
    Form{"VolumeIntegrator", 1},
};

/// nullptr where it takes none.
const Form *FormOf(std::string_view directive) {
    const auto *const found = std::find_if(kWithParameters.begin(), kWithParameters.end(),
                                           [&](const Form &f) { return f.directive == directive; });
    return found == kWithParameters.end() ? nullptr : &*found;
}

bool IsDirective(std::string_view word) {
    return FindDirective(word) || FormOf(word) || FindOldName("directive", word);
}

std::string_view WithoutBlanksAtEnd(std::string_view text) {
    const size_t last = text.find_last_not_of(" \t\r");
    return text.substr(0, last == text.npos ? 0 : last + 1);
}

}  // namespace

StatementReader::StatementReader(std::string_view text, std::string_view file, Diagnostics *log)
    : lexer(text, file, log), log(log) {
    ReadGap();
}

void StatementReader::Advance() {
    lexer.Advance();
    ReadGap();
}

void StatementReader::ReadGap() {
    std::string_view gap = lexer.Before();
    for (bool first = true;; first = false) {
        const size_t end = gap.find('\n');
        const std::string_view line = gap.substr(0, end);
        const size_t hash = line.find('#');
        const std::string_view comment =
            hash == line.npos ? std::string_view() : WithoutBlanksAtEnd(line.substr(hash));
        const bool isTokensLine = end == gap.npos;
        if (first && !comment.empty())
            remark = comment;
        else if (!comment.empty())
            lines.emplace_back(comment);
        else if (!first && !isTokensLine && (lines.empty() || !lines.back().empty()))
            lines.emplace_back();
        if (isTokensLine) return;
        gap.remove_prefix(end + 1);
    }
}

void StatementReader::TakeComments(std::vector<std::string> *above, bool withEmptyLines) {
    if (!remark.empty()) above->push_back(TakeRemark());
    for (std::string &line : lines)
        if (withEmptyLines || !line.empty()) above->push_back(std::move(line));
    lines.clear();
}

std::string StatementReader::TakeRemark() {
    return std::exchange(remark, {});
}

std::optional<Statement> StatementReader::Next() {
    const Token &token = lexer.Peek();
    Statement s;
    s.loc = lexer.Loc();
    TakeComments(&s.comments, true);
    if (token.kind == TokenKind::End)
        return s.comments.empty() ? std::nullopt : std::optional(std::move(s));
    if (token.kind != TokenKind::Word || !IsDirective(token.text)) {
        if (!lexer.ReportMissingQuote() && token.kind != TokenKind::Broken)
            log->Error(lexer.Loc(), fmt::format("expected a directive, found {}{}", Describe(token),
                                                token.kind == TokenKind::Word
                                                    ? DidYouMean(token.text, DirectiveNames())
                                                    : std::string()));
        return {};
    }
    s.directive = token.text;
    Advance();
    const Form *const form = FormOf(s.directive);
    const bool read = form ? ReadNames(form->names, &s) && ReadParameters(&s) : ReadArguments(&s);
    return read ? std::optional(std::move(s)) : std::nullopt;
}

/// All up to the next directive.
bool StatementReader::ReadArguments(Statement *s) {
    const Token &t = lexer.Peek();
    while (t.kind != TokenKind::End) {
        if (t.kind == TokenKind::Broken) return false;
        const bool isTimes = s->directive == "ActiveTransform" && s->arguments.empty();
        if (t.kind == TokenKind::Word && MayBeDirective(t.text) && !isTimes) break;
        TakeComments(&s->comments, false);
        s->arguments.emplace_back(lexer.Written());
        Advance();
    }
    s->remark = TakeRemark();
    return true;
}

bool StatementReader::ReadNames(int count, Statement *s) {
    for (int i = 0; i < count; ++i) {
        if (lexer.Peek().kind != TokenKind::String)
            return Expected(fmt::format("a name in quotes after {}", s->directive));
        TakeComments(&s->comments, false);
        s->arguments.emplace_back(lexer.Written());
        Advance();
    }
    s->remark = TakeRemark();
    return true;
}

bool StatementReader::ReadParameters(Statement *s) {
    const Token &t = lexer.Peek();
    while (t.kind == TokenKind::String) {
        const Declaration d = SplitDeclaration(t.text);
        if (d.name.empty()) return Expected("a parameter's \"type name\"");
        Parameter &p = s->parameters.emplace_back();
        p.type = d.type;
        p.name = d.name;
        p.loc = lexer.Loc();
        TakeComments(&p.comments, false);
        Advance();
        if (!ReadValues(&p)) return false;
        p.remark = TakeRemark();
    }
    return t.kind != TokenKind::Broken;
}

bool StatementReader::ReadValues(Parameter *p) {
    const Token &t = lexer.Peek();
    const bool inList = t.kind == TokenKind::Open;
    TakeComments(&p->comments, false);
    if (inList) Advance();
    const auto isValue = [&] {
        const bool isWord = t.kind == TokenKind::Word && !IsDirective(t.text);
        return isWord || t.kind == TokenKind::String;
    };
    while (isValue() && (inList || p->values.empty())) {
        TakeComments(&p->comments, false);
        p->values.emplace_back(lexer.Written());
        Advance();
    }
    if (p->values.empty()) return Expected("a value");
    if (!inList) return true;
    if (t.kind != TokenKind::Close) return Expected("a value or \"]\"");
    TakeComments(&p->comments, false);
    Advance();
    return true;
}

bool StatementReader::Expected(std::string_view what) {
    if (lexer.Peek().kind == TokenKind::Broken || lexer.ReportMissingQuote()) return false;
    log->Error(lexer.Loc(), fmt::format("expected {}, found {}", what, Describe(lexer.Peek())));
    return false;
}

}  // namespace pbrt::rewrite
