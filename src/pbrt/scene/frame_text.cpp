#include "pbrt/scene/frame_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "pbrt/scene/quoted_words.h"
#include "pbrt/util/diagnostics.h"
#include "pbrt/util/parse_number.h"

namespace pbrt {
namespace {

constexpr std::string_view kFrame = "frame";

/// slope * frame + constant.
struct Linear {
    double slope = 0, constant = 0;
};

/// Reads an expression; by hand, for a library would be larger than its grammar:
///   sum      product { (+ | -) product }
///   product  factor { (* | /) factor }
///   factor   [-] ( number | frame | "(" sum ")" )
class Expression {
  public:
    explicit Expression(std::string_view text) : rest(text) {}

    OrError<Linear> Read() {
        const Linear value = Sum();
        if (why.empty() && !Peek().empty()) Fail(fmt::format("what is \"{}\"?", rest));
        if (!why.empty()) return {{}, why};
        return {value, {}};
    }

  private:
    Linear Sum() {
        Linear sum = Product();
        while (why.empty()) {
            if (Take('+')) {
                const Linear b = Product();
                sum = {sum.slope + b.slope, sum.constant + b.constant};
            } else if (Take('-')) {
                const Linear b = Product();
                sum = {sum.slope - b.slope, sum.constant - b.constant};
            } else {
                break;
            }
        }
        return sum;
    }
    Linear Product() {
        Linear product = Factor();
        while (why.empty()) {
            if (Take('*')) {
                const Linear b = Factor();
                if (product.slope != 0 && b.slope != 0) Fail("it is not linear in frame");
                product = {product.slope * b.constant + product.constant * b.slope,
                           product.constant * b.constant};
            } else if (Take('/')) {
                const Linear b = Factor();
                if (b.slope != 0) Fail("it is not linear in frame");
                if (b.slope == 0 && b.constant == 0) Fail("it divides by 0");
                product = {product.slope / b.constant, product.constant / b.constant};
            } else {
                break;
            }
        }
        return product;
    }
    Linear Factor() {
        constexpr int kDeepest = 100;
        if (++depth > kDeepest) Fail("it is nested too deep");
        Linear value;
        if (!why.empty()) return value;
        if (Take('-')) {
            value = Factor();
            value = {-value.slope, -value.constant};
        } else if (Take('(')) {
            value = Sum();
            if (why.empty() && !Take(')')) Fail("a \")\" is missing");
        } else if (Peek().starts_with(kFrame)) {
            rest.remove_prefix(kFrame.size());
            value.slope = 1;
        } else {
            value.constant = Number();
        }
        --depth;
        return value;
    }
    double Number() {
        const std::string_view text = Peek();
        size_t n = 0;
        while (n < text.size() &&
               (std::isdigit(static_cast<unsigned char>(text[n])) || text[n] == '.' ||
                ((text[n] == 'e' || text[n] == 'E') && n > 0) ||
                ((text[n] == '-' || text[n] == '+') && n > 0 && (text[n - 1] | 32) == 'e')))
            ++n;
        const std::optional<double> number = ParseNumber(text.substr(0, n));
        if (!number)
            Fail(text.empty() ? std::string("a number or frame is missing")
                              : fmt::format("\"{}\" is neither a number nor frame", text));
        rest.remove_prefix(n);
        return number.value_or(0);
    }
    /// The rest, without blanks before it.
    std::string_view Peek() {
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        return rest;
    }
    bool Take(char c) {
        if (!Peek().starts_with(c)) return false;
        rest.remove_prefix(1);
        return true;
    }
    void Fail(const std::string &reason) {
        if (why.empty()) why = reason;
    }

    std::string_view rest;
    std::string why;
    int depth = 0;
};

std::string NumberText(double value) {
    if (value == std::floor(value) && std::abs(value) < 1e15)
        return fmt::format("{}", int64_t(value));
    return fmt::format("{}", value);
}

/// A `$frame` or `$(...)`.
struct Place {
    size_t size = 0;  ///< of the text that is replaced; 0: it is neither
    std::string_view expression;
};

Place PlaceAt(std::string_view text) {
    if (text.starts_with("$frame")) return {1 + kFrame.size(), text.substr(1, kFrame.size())};
    if (!text.starts_with("$(")) return {};
    int open = 0;
    const std::string_view line = text.substr(0, text.find_first_of("\n\""));
    for (size_t i = 1; i < line.size(); ++i) {
        open += line[i] == '(' ? 1 : line[i] == ')' ? -1 : 0;
        if (open == 0) return {i + 1, text.substr(2, i - 2)};
    }
    return {line.size(), line.substr(1)};  // with the "(" that is not closed, which is told
}

OrError<std::string> Put(std::string_view text, int frame, bool comments) {
    std::string out;
    bool quoted = false;
    for (size_t at = 0; at < text.size();) {
        const size_t next =
            std::min(text.find_first_of(comments ? "$#\"\n" : "$", at), text.size());
        out += text.substr(at, next - at);
        at = next;
        if (at == text.size()) break;
        const bool escaped = quoted && at > 0 && text[at - 1] == '\\';
        if (text[at] == '"' && !escaped) quoted = !quoted;
        if (text[at] == '\n') quoted = false;
        const Place place = PlaceAt(text.substr(at));
        const size_t kept = text[at] == '#' && !quoted ? EndOfComment(text, at) - at : 1;
        if (place.size == 0) {
            out += text.substr(at, kept);
            at += kept;
            continue;
        }
        const OrError<Linear> value = Expression(place.expression).Read();
        if (!value) {
            const auto line = std::count(text.begin(), text.begin() + ptrdiff_t(at), '\n') + 1;
            return {{},
                    fmt::format("line {}: {}: {}", line, Shortened(text.substr(at, place.size)),
                                value.error)};
        }
        out += NumberText(value.value->slope * frame + value.value->constant);
        at += place.size;
    }
    return {std::move(out), {}};
}

}  // namespace

OrError<std::string> PutFrame(std::string_view text, int frame) {
    return Put(text, frame, true);
}

OrError<std::string> PutFrameInName(std::string_view name, int frame) {
    return Put(name, frame, false);
}

bool NamesFrame(std::string_view name) {
    const OrError<std::string> first = PutFrameInName(name, 0), second = PutFrameInName(name, 1);
    return !first || !second || *first.value != *second.value;
}

}  // namespace pbrt
