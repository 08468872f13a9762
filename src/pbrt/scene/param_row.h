#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace pbrt {

// One row for each parameter of a plug-in: what a scene writes as `"type name" [ values ]`. A
// parameter can only be read through its row (ParamDict), and what a plug-in's Create reads is what
// `pbrt --explain` and docs/REFERENCE.md show: the same rows feed parsing, range errors, the manual
// and the tests' corner cases. Texts must outlive the program's use of them: literals.
//   name  as in the scene file       unit  of the values; empty: none, or the scene's own
//   def   default value, used where the parameter is not given
//   lo, hi  legal range, both ends included; +-kOpen or an integer's limits: open
//   doc   what it means, a phrase without a full stop

/// Open end of a range.
inline constexpr float kOpen = std::numeric_limits<float>::infinity();
/// Lower end of a range that leaves out 0: the least float above it. Shown as `> 0` or `(0, hi]`.
inline constexpr float kAboveZero = std::numeric_limits<float>::denorm_min();
/// Open ends of an integer's range.
inline constexpr int kLeastInt = std::numeric_limits<int>::min();
inline constexpr int kMostInt = std::numeric_limits<int>::max();

/// `float`; where Create asks for a texture, that may be given instead.
struct FloatParam {
    std::string_view name, unit;
    float def, lo, hi;
    std::string_view doc;

    constexpr bool Legal(float value) const { return lo <= value && value <= hi; }
};
/// `integer`.
struct IntParam {
    std::string_view name;
    int def, lo, hi;
    std::string_view doc;

    constexpr bool Legal(int value) const { return lo <= value && value <= hi; }
};
/// `bool`.
struct BoolParam {
    std::string_view name;
    bool def;
    std::string_view doc;
};
/// `string`: any text, or a file's name.
struct StringParam {
    std::string_view name, def, doc;
};
/// `string`: one of a few words.
struct ChoiceParam {
    std::string_view name, def;
    std::span<const std::string_view> allowed;
    std::string_view doc;
};

/// Kind of spectrum that an RGB color becomes.
enum class SpectrumType { Albedo, Unbounded, Illuminant };

/// `rgb`, `blackbody` or `spectrum`; where Create asks for a texture, that may be given instead.
struct SpectrumParam {
    std::string_view name;
    SpectrumType role;
    std::string_view def;  ///< a number, a built-in spectrum's name, or words where Create knows it
    std::string_view doc;
    float lo = 0;  ///< of the values at each wavelength; RGB is checked by role, others by Create
    float hi = role == SpectrumType::Albedo ? 1 : kOpen;
};
/// One point or vector.
struct PointParam {
    std::string_view name;
    std::string_view type;  ///< "point3" or "vector3"
    std::array<float, 3> def;
    std::string_view doc;
};
/// A list, empty where it is not given.
struct ArrayParam {
    std::string_view name;
    std::string_view type;  ///< of the scene language: "point3", "integer", ...
    std::string_view def;   ///< what is done without the list, in words
    std::string_view doc;
};

using ParamRow = std::variant<FloatParam, IntParam, BoolParam, StringParam, ChoiceParam,
                              SpectrumParam, PointParam, ArrayParam>;

/// A parameter that a plug-in asked for.
struct RequestedParam {
    ParamRow row;
    bool texture = false;  ///< `texture` is allowed, too
};

std::string_view NameOf(const ParamRow &row);
/// The types of the scene language that a value may have, without "texture". Points into the row
/// where that is one of points or lists.
std::span<const std::string_view> TypesOf(const ParamRow &row);
/// The same with "texture" for readers, as "float or texture".
std::string TypesOf(const RequestedParam &param);
std::string_view UnitOf(const ParamRow &row);
/// Default and range, each as the manual shows it; empty where there is none.
std::string DefaultOf(const ParamRow &row);
std::string RangeOf(const ParamRow &row);
std::string_view DocOf(const ParamRow &row);

/// Why the row does not allow the value, naming its range: "7 is outside [0, 1] nm". Empty where it
/// does.
std::string WhyIllegal(float value, const FloatParam &row);
std::string WhyIllegal(int value, const IntParam &row);

}  // namespace pbrt
