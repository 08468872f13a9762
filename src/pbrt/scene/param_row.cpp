#include "pbrt/scene/param_row.h"

#include <fmt/format.h>

#include <vector>

namespace pbrt {
namespace {

template <typename... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};

constexpr std::array<std::string_view, 1> kFloat{"float"}, kInt{"integer"}, kBool{"bool"},
    kString{"string"};
constexpr std::array<std::string_view, 3> kSpectrum{"rgb", "spectrum", "blackbody"};

/// Ends of a range; infinity stands for an integer's limits.
template <typename Number>
struct Range {
    Number lo, hi;

    bool OpenBelow() const { return lo <= std::numeric_limits<Number>::lowest(); }
    bool OpenAbove() const { return hi >= std::numeric_limits<Number>::max(); }
    bool WithoutZero() const { return lo == Number(kAboveZero) && lo != 0; }
    /// Range with two ends.
    std::string Interval() const {
        return WithoutZero() ? fmt::format("(0, {}]", hi) : fmt::format("[{}, {}]", lo, hi);
    }
    std::string Shown() const {
        if (OpenBelow() && OpenAbove()) return {};
        if (OpenBelow()) return fmt::format("<= {}", hi);
        if (!OpenAbove()) return Interval();
        return WithoutZero() ? "> 0" : fmt::format(">= {}", lo);
    }
    std::string WhyOutside(Number value) const {
        if (OpenBelow()) return fmt::format("{} is more than {}", value, hi);
        if (!OpenAbove()) return fmt::format("{} is outside {}", value, Interval());
        return WithoutZero() ? fmt::format("{} is not more than 0", value)
                             : fmt::format("{} is less than {}", value, lo);
    }
};

std::string Shown(std::string_view text) {
    return text.empty() ? std::string() : fmt::format("\"{}\"", text);
}

}  // namespace

std::string_view NameOf(const ParamRow &row) {
    return std::visit([](const auto &r) { return r.name; }, row);
}

std::string_view DocOf(const ParamRow &row) {
    return std::visit([](const auto &r) { return r.doc; }, row);
}

std::string_view UnitOf(const ParamRow &row) {
    const auto *const number = std::get_if<FloatParam>(&row);
    return number ? number->unit : std::string_view();
}

std::span<const std::string_view> TypesOf(const ParamRow &row) {
    using Types = std::span<const std::string_view>;
    return std::visit(Overloaded{[](const FloatParam &) { return Types(kFloat); },
                                 [](const IntParam &) { return Types(kInt); },
                                 [](const BoolParam &) { return Types(kBool); },
                                 [](const StringParam &) { return Types(kString); },
                                 [](const ChoiceParam &) { return Types(kString); },
                                 [](const SpectrumParam &) { return Types(kSpectrum); },
                                 [](const auto &list) { return Types(&list.type, 1); }},
                      row);
}

std::string TypesOf(const RequestedParam &param) {
    const std::span<const std::string_view> types = TypesOf(param.row);
    std::vector<std::string_view> all(types.begin(), types.end());
    if (param.texture) all.push_back("texture");
    const std::string_view last = all.back();
    all.pop_back();
    return all.empty() ? std::string(last) : fmt::format("{} or {}", fmt::join(all, ", "), last);
}

std::string DefaultOf(const ParamRow &row) {
    return std::visit(
        Overloaded{[](const FloatParam &r) { return fmt::format("{}", r.def); },
                   [](const IntParam &r) { return fmt::format("{}", r.def); },
                   [](const BoolParam &r) { return std::string(r.def ? "true" : "false"); },
                   [](const StringParam &r) { return Shown(r.def); },
                   [](const ChoiceParam &r) { return Shown(r.def); },
                   [](const PointParam &r) { return fmt::format("{}", fmt::join(r.def, " ")); },
                   [](const auto &r) { return std::string(r.def); }},
        row);
}

std::string RangeOf(const ParamRow &row) {
    return std::visit(Overloaded{[](const FloatParam &r) {
                                     return Range<float>{r.lo, r.hi}.Shown();
                                 },
                                 [](const IntParam &r) {
                                     return Range<int>{r.lo, r.hi}.Shown();
                                 },
                                 [](const SpectrumParam &r) {
                                     return Range<float>{r.lo, r.hi}.Shown();
                                 },
                                 [](const ChoiceParam &r) {
                                     return fmt::format("{}", fmt::join(r.allowed, ", "));
                                 },
                                 [](const auto &) { return std::string(); }},
                      row);
}

std::string WhyIllegal(float value, const FloatParam &row) {
    if (row.Legal(value)) return {};
    const std::string why = Range<float>{row.lo, row.hi}.WhyOutside(value);
    return row.unit.empty() ? why : fmt::format("{} {}", why, row.unit);
}

std::string WhyIllegal(int value, const IntParam &row) {
    return row.Legal(value) ? std::string() : Range<int>{row.lo, row.hi}.WhyOutside(value);
}

}  // namespace pbrt
