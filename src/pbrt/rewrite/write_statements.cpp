#include "pbrt/rewrite/write_statements.h"

#include <fmt/format.h>

#include <algorithm>

namespace pbrt::rewrite {
namespace {

constexpr int kStep = 4;
constexpr size_t kWidth = 100;

/// A parameter as words of a line.
std::vector<std::string> Words(const Parameter &p) {
    std::vector<std::string> words{fmt::format("\"{} {}\"", p.type, p.name), "["};
    words.insert(words.end(), p.values.begin(), p.values.end());
    words.emplace_back("]");
    return words;
}

size_t Length(const std::vector<std::string> &words) {
    size_t length = 0;
    for (const std::string &word : words)
        length += word.size() + 1;
    return length;
}

}  // namespace

void StatementWriter::Write(const Statement &s) {
    const bool opens = s.directive.ends_with("Begin"), closes = s.directive.ends_with("End");
    const bool isWorld = s.directive == "WorldBegin";
    if (opens) EmptyLine();
    Comments(s.comments, indent);
    if (s.directive.empty()) return;
    if (closes) indent = std::max(0, indent - kStep);
    std::vector<std::string> words{s.directive};
    words.insert(words.end(), s.arguments.begin(), s.arguments.end());
    // A single short parameter stands in the same line.
    const bool isShort = s.parameters.size() == 1 && s.parameters[0].comments.empty() &&
                         s.remark.empty() &&
                         size_t(indent) + Length(words) + Length(Words(s.parameters[0])) < kWidth;
    if (isShort) {
        const std::vector<std::string> more = Words(s.parameters[0]);
        words.insert(words.end(), more.begin(), more.end());
    }
    Line(words, indent, isShort ? s.parameters[0].remark : s.remark);
    if (!isShort) Parameters(s);
    if (isWorld) EmptyLine();
    if (opens && !isWorld) indent += kStep;
}

void StatementWriter::Parameters(const Statement &s) {
    for (const Parameter &p : s.parameters) {
        Comments(p.comments, indent + kStep);
        Line(Words(p), indent + kStep, p.remark);
    }
}

void StatementWriter::EmptyLine() {
    if (!text.empty() && !text.ends_with("\n\n")) text += '\n';
}

void StatementWriter::Comments(const std::vector<std::string> &comments, int column) {
    for (const std::string &comment : comments)
        if (comment.empty())
            EmptyLine();
        else
            Line({comment}, column, {});
}

void StatementWriter::Line(const std::vector<std::string> &words, int column,
                           const std::string &remark) {
    const auto begin = [&](int at) { text.append(size_t(at), ' '); };
    begin(column);
    size_t start = text.size() - size_t(column);
    for (size_t i = 0; i < words.size(); ++i) {
        const bool first = i == 0;
        if (!first && text.size() - start + 1 + words[i].size() > kWidth) {
            text += '\n';
            start = text.size();
            begin(column + kStep);
        } else if (!first) {
            text += ' ';
        }
        text += words[i];
    }
    if (!remark.empty()) text.append("  ").append(remark);
    text += '\n';
}

}  // namespace pbrt::rewrite
