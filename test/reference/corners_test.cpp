// Every type of every family, held against the rows that its Create asks for.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "pbrt/reference/families.h"

namespace pbrt::reference {
namespace {

using Texts = std::vector<std::string>;

struct Case {
    const Family &family;
    std::string_view type;
    std::string What() const { return fmt::format("{} \"{}\"", family.name, type); }
};

std::vector<Case> AllTypes() {
    std::vector<Case> all;
    for (const Family &family : Families())
        for (const std::string_view type : family.types())
            all.push_back({family, type});
    return all;
}

ParsedParameter Number(std::string_view name, float value) {
    ParsedParameter p;
    p.type = "float", p.name = name, p.floats = {value};
    return p;
}
ParsedParameter Number(std::string_view name, int value) {
    ParsedParameter p;
    p.type = "integer", p.name = name, p.ints = {value};
    return p;
}
ParsedParameter Word(std::string_view name, std::string_view value) {
    ParsedParameter p;
    p.type = "string", p.name = name, p.strings = {std::string(value)};
    return p;
}

/// What creating says beyond what it says without the last of the parameters.
Texts NewMessages(const Case &c, ParsedParameters params) {
    Texts now;
    for (const Message &m : Create(c.family, c.type, params).messages)
        now.push_back(m.text);
    params.pop_back();
    for (const Message &m : Create(c.family, c.type, params).messages)
        std::erase(now, m.text);
    return now;
}

/// Ends of ranges that are legal by themselves and not beside the defaults of other parameters.
struct Exception {
    std::string_view what, name;
    ParsedParameters beside;       ///< makes both ends legal
    bool low = true, high = true;  ///< whether that end can be legal at all
};

/// The reasons: a film of 65536 x 720 pixels takes more memory than tests should; ranges of
/// wavelengths, times and cuts must not be empty; what is shorter than 1e-18 or farther than 1e18
/// has no square in float, which the whole shape or camera is held against; cells differ only
/// where there are any.
const std::vector<Exception> &Exceptions() {
    static const std::vector<Exception> all = [] {
        std::vector<Exception> list;
        for (const std::string_view film :
             {"film \"rgb\"", "film \"gbuffer\"", "film \"spectral\""}) {
            list.push_back({film, "xresolution", {Number("yresolution", 1)}});
            list.push_back({film, "yresolution", {Number("xresolution", 1)}});
        }
        list.push_back({"film \"spectral\"", "lambdamin", {}, true, false});
        list.push_back({"film \"spectral\"", "lambdamax", {}, false, true});
        list.push_back({"film \"spectral\"",
                        "nbuckets",
                        {Number("xresolution", 1), Number("yresolution", 1)}});
        for (const std::string_view camera :
             {"camera \"perspective\"", "camera \"orthographic\"", "camera \"spherical\""}) {
            list.push_back({camera, "shutteropen", {}, true, false});
            list.push_back({camera, "shutterclose", {}, false, true});
        }
        for (const std::string_view quadric :
             {"shape \"sphere\"", "shape \"disk\"", "shape \"cylinder\""})
            list.push_back({quadric, "radius", {}, false, true});
        for (const std::string_view deviation : {"cellthickness", "celltilt", "cellbend"})
            list.push_back({"material \"featherbarbule\"",
                            deviation,
                            {Number("cellsacross", 1.f), Number("cellsalong", 1.f)}});
        return list;
    }();
    return all;
}

const Exception *ExceptionFor(const Case &c, std::string_view name) {
    for (const Exception &e : Exceptions())
        if (e.what == c.What() && e.name == name) return &e;
    return nullptr;
}

/// Ends of a range that are none.
bool IsOpen(float end) {
    return std::isinf(end);
}
bool IsOpen(int end) {
    return end == kLeastInt || end == kMostInt;
}

template <typename Number>
std::optional<Number> Below(Number end) {
    if (IsOpen(end)) return {};
    if constexpr (std::is_same_v<Number, int>)
        return end - 1;
    else
        return std::nextafter(end, -kOpen);
}
template <typename Number>
std::optional<Number> Above(Number end) {
    if (IsOpen(end)) return {};
    if constexpr (std::is_same_v<Number, int>)
        return end + 1;
    else
        return std::nextafter(end, kOpen);
}

/// The choice beside which the plug-in asks for the row; nothing where it always does.
ParsedParameters Chosen(const Case &c, std::string_view name) {
    const std::vector<RequestedParam> plain = Create(c.family, c.type, {}).requested;
    const auto asks = [&](const std::vector<RequestedParam> &rows) {
        return std::any_of(rows.begin(), rows.end(),
                           [&](const RequestedParam &r) { return NameOf(r.row) == name; });
    };
    if (asks(plain)) return {};
    for (const RequestedParam &r : plain)
        if (const auto *const choice = std::get_if<ChoiceParam>(&r.row))
            for (const std::string_view value : choice->allowed)
                if (asks(Create(c.family, c.type, {Word(choice->name, value)}).requested))
                    return {Word(choice->name, value)};
    ADD_FAILURE() << c.What() << " never asks for " << name;
    return {};
}

template <typename Row>
void CheckEnds(const Case &c, const Row &row) {
    const Exception *const exception = ExceptionFor(c, row.name);
    ParsedParameters params = Chosen(c, row.name);
    if (exception) params.insert(params.end(), exception->beside.begin(), exception->beside.end());
    const auto said = [&](auto value) {
        ParsedParameters all = params;
        all.push_back(Number(row.name, value));
        return NewMessages(c, all);
    };
    EXPECT_TRUE(row.Legal(row.def)) << c.What() << " " << row.name;
    EXPECT_EQ(said(row.def), Texts{}) << c.What() << " " << row.name;
    const bool low = !exception || exception->low, high = !exception || exception->high;
    if (!IsOpen(row.lo)) {
        EXPECT_EQ(said(row.lo).empty(), low) << c.What() << " " << row.name;
    }
    if (!IsOpen(row.hi)) {
        EXPECT_EQ(said(row.hi).empty(), high) << c.What() << " " << row.name;
    }
    for (const auto outside : {Below(row.lo), Above(row.hi)}) {
        if (!outside) continue;
        const Texts texts = said(*outside);
        ASSERT_FALSE(texts.empty()) << c.What() << " " << row.name << " " << *outside;
        EXPECT_NE(texts.front().find(WhyIllegal(*outside, row)), std::string::npos)
            << c.What() << ": " << texts.front();
    }
}

TEST(EveryPlugIn, TakesTheEndsOfItsRangesAndNothingBeyond) {
    for (const Case &c : AllTypes())
        for (const RequestedParam &r : ParametersOf(c.family, c.type)) {
            if (const auto *const row = std::get_if<FloatParam>(&r.row)) CheckEnds(c, *row);
            if (const auto *const row = std::get_if<IntParam>(&r.row)) CheckEnds(c, *row);
        }
}

TEST(EveryPlugIn, TakesEveryWordOfItsChoices) {
    for (const Case &c : AllTypes())
        for (const RequestedParam &r : ParametersOf(c.family, c.type)) {
            const auto *const row = std::get_if<ChoiceParam>(&r.row);
            if (!row) continue;
            EXPECT_NE(std::find(row->allowed.begin(), row->allowed.end(), row->def),
                      row->allowed.end())
                << c.What() << " " << row->name;
            for (const std::string_view value : row->allowed)
                for (const std::string &text : NewMessages(c, {Word(row->name, value)}))
                    EXPECT_EQ(text.find("is not one of"), std::string::npos) << text;
            const Texts refused = NewMessages(c, {Word(row->name, "?")});
            ASSERT_FALSE(refused.empty()) << c.What() << " " << row->name;
            EXPECT_NE(refused.front().find("\"?\" is not one of"), std::string::npos)
                << refused.front();
        }
}

TEST(EveryPlugIn, SuggestsTheNearestNameForAMisspeltOne) {
    constexpr size_t kShort = 3;  // nothing is near "P"
    for (const Case &c : AllTypes())
        for (const RequestedParam &r : Create(c.family, c.type, {}).requested) {
            const std::string name(NameOf(r.row));
            if (name.size() <= kShort) continue;
            const Texts texts = NewMessages(c, {Number(name + "_", 1.f)});
            const bool suggests =
                std::any_of(texts.begin(), texts.end(), [&](const std::string &text) {
                    return text.find("did you mean \"" + name + "\"?") != text.npos;
                });
            EXPECT_TRUE(suggests) << c.What() << " " << name << ": "
                                  << (texts.empty() ? "nothing" : texts.front());
        }
}

TEST(EveryPlugIn, DocumentsEachParameterOnce) {
    for (const Case &c : AllTypes()) {
        std::set<std::string> seen;
        for (const RequestedParam &r : ParametersOf(c.family, c.type)) {
            const std::string_view doc = DocOf(r.row);
            EXPECT_FALSE(doc.empty()) << c.What() << " " << NameOf(r.row);
            EXPECT_FALSE(doc.ends_with('.')) << c.What() << " " << NameOf(r.row);
            EXPECT_LE(doc.size(), 85u) << c.What() << " " << NameOf(r.row);
            EXPECT_TRUE(seen.insert(fmt::format("{} {}", NameOf(r.row), TypesOf(r))).second)
                << c.What() << " " << NameOf(r.row);
        }
    }
}

std::set<std::string> NamesIn(const std::vector<RequestedParam> &rows) {
    std::set<std::string> names;
    for (const RequestedParam &r : rows)
        names.emplace(NameOf(r.row));
    return names;
}

TEST(EveryPlugIn, AsksForTheSameNamesWhateverNumberIsGiven) {
    for (const Case &c : AllTypes()) {
        const std::vector<RequestedParam> plain = Create(c.family, c.type, {}).requested;
        for (const RequestedParam &r : plain)
            if (const auto *const row = std::get_if<FloatParam>(&r.row)) {
                const Trial trial = Create(c.family, c.type, {Number(row->name, row->def)});
                EXPECT_EQ(NamesIn(trial.requested), NamesIn(plain)) << c.What() << " " << row->name;
            }
    }
}

}  // namespace
}  // namespace pbrt::reference
