#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "pbrt/util/parse_number.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

// Options of programs; those without dashes are arguments, in the order of their definition. Each
// takes one word, lists too (`--crop 0,9,0,9`), so that what follows is never taken for a part of
// it; --help and messages say what the word may be.
namespace pbrt::cli {

/// The numbers an option takes: finite ones in [lo, hi], or (lo, hi] where `above`.
struct Domain {
    double lo = -std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();
    bool above = false;

    bool Holds(double x) const { return x <= hi && (above ? x > lo : x >= lo); }
};
inline constexpr Domain kAboveZero{.lo = 0, .above = true};
inline constexpr Domain kFromZero{.lo = 0};

/// ` above 0`, ` from 1 to 9`, ` of at least 0`, ` of at most 9` or nothing.
std::string InWords(const Domain &domain);
/// The same for --help: ` > 0`, ` in [1, 9]`, ` >= 0`, ` <= 9` or nothing.
std::string InSigns(const Domain &domain);

/// Ends the parsing of the command line: "<option>: expected <wanted>, found <text>".
[[noreturn]] void Refuse(const std::string &option, const std::string &wanted,
                         const std::string &text);

/// `option` takes one word, which `read` takes or Refuses. `form` stands for it in --help.
CLI::Option *AddWord(CLI::App *app, const std::string &option,
                     std::function<void(const std::string &word)> read, const std::string &doc,
                     const std::string &form);

/// `option` takes any word.
CLI::Option *AddText(CLI::App *app, const std::string &option, std::string *value,
                     const std::string &doc, const std::string &form = "TEXT");
/// The same where it must be given.
void AddRequired(CLI::App *app, const std::string &option, std::string *value,
                 const std::string &doc);
/// An argument of one word or more, or where it need not be given, of any number.
void AddRequired(CLI::App *app, const std::string &argument, std::vector<std::string> *values,
                 const std::string &doc);
void AddTexts(CLI::App *app, const std::string &argument, std::vector<std::string> *values,
              const std::string &doc);
/// `option` takes one word each time it is given.
void AddRepeated(CLI::App *app, const std::string &option, std::vector<std::string> *values,
                 const std::string &doc, const std::string &form = "TEXT");
void AddFlag(CLI::App *app, const std::string &option, bool *value, const std::string &doc);
/// Only one of the two may be given.
void Exclude(CLI::Option *option, CLI::Option *other);
/// Text below the options in --help.
void AddFooter(CLI::App *app, const std::string &text);

/// `domain` cut down to the numbers T has, on the side where the text's number is beyond them.
template <typename T>
Domain Representable(Domain domain, double number) {
    constexpr double least = double(std::numeric_limits<T>::lowest());
    constexpr double most = double(std::numeric_limits<T>::max());
    if (number > most) domain.hi = std::min(domain.hi, most);
    if (number < least && domain.lo < least) domain.lo = least, domain.above = false;
    return domain;
}

/// The number in `text`, nullopt where it is none of `domain`. Whole numbers may be written with an
/// exponent: 1e3. `domain` becomes what to name in a message.
template <typename T>
std::optional<T> ReadOne(const std::string &text, Domain *domain) {
    if constexpr (std::is_integral_v<T>) {
        if (const std::optional<T> exact = ParseWhole<T>(text))  // digits beyond those of a double
            return domain->Holds(double(*exact)) ? exact : std::nullopt;
    }
    const std::optional<double> number = ParseNumber(text);
    if (!number) return {};
    *domain = Representable<T>(*domain, *number);
    if (!domain->Holds(*number)) return {};
    if constexpr (std::is_integral_v<T>) {
        // 2^64 as a double is the limit's neighbour, and no uint64_t.
        const double beyond = std::ldexp(1., std::numeric_limits<T>::digits);
        if (*number != std::floor(*number) || *number >= beyond) return {};
    }
    return T(*number);
}

/// `option` takes one number. T: an integer or floating-point type.
template <typename T>
CLI::Option *AddNumber(CLI::App *app, const std::string &option, T *value, const Domain &domain,
                       const std::string &doc) {
    constexpr bool kWhole = std::is_integral_v<T>;
    const auto read = [=](const std::string &text) {
        Domain named = domain;
        const std::optional<T> number = ReadOne<T>(text, &named);
        if (!number)
            Refuse(option, (kWhole ? "a whole number" : "a number") + InWords(named), text);
        *value = *number;
    };
    return AddWord(app, option, read, doc, (kWhole ? "INTEGER" : "NUMBER") + InSigns(domain));
}

/// The parts of a list, which is words joined by commas.
std::vector<std::string> SplitList(const std::string &text);

/// `option` takes as many numbers as `parts`, such as "x0,x1,y0,y1", names.
template <typename T>
CLI::Option *AddNumbers(CLI::App *app, const std::string &option, std::vector<T> *values,
                        const std::string &parts, const Domain &domain, const std::string &doc) {
    const auto read = [=](const std::string &text) {
        const std::vector<std::string> words = SplitList(text);
        const size_t count = SplitList(parts).size();
        std::vector<T> numbers;
        Domain named = domain;
        for (const std::string &word : words)
            if (const std::optional<T> number = ReadOne<T>(word, &named))
                numbers.push_back(*number);
        if (words.size() != count || numbers.size() != count)
            Refuse(option,
                   std::to_string(count) +
                       (std::is_integral_v<T> ? " whole numbers " : " numbers ") + parts +
                       InWords(named),
                   text);
        *values = numbers;
    };
    return AddWord(app, option, read, doc, parts);
}

/// `option` takes names joined by commas.
CLI::Option *AddNames(CLI::App *app, const std::string &option, std::vector<std::string> *names,
                      const std::string &parts, const std::string &doc);

/// `option` takes one of `allowed`.
CLI::Option *AddChoice(CLI::App *app, const std::string &option, std::string *value,
                       std::initializer_list<std::string_view> allowed, const std::string &doc);

}  // namespace pbrt::cli
