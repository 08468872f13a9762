#pragma once

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
//   def   what counts where the parameter is not given
//   lo, hi  legal range, both ends included; +-Infinity: open
//   doc   what it means, a phrase without a full stop

/// `float`; where Create asks for a texture, that may be given instead.
struct FloatParam {
    std::string_view name, unit;
    float def, lo, hi;
    std::string_view doc;
};
/// `integer`.
struct IntParam {
    std::string_view name;
    int def, lo, hi;
    std::string_view doc;
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

/// How an RGB color becomes a spectrum.
enum class SpectrumType { Albedo, Unbounded, Illuminant };

/// `rgb`, `blackbody` or `spectrum`; where Create asks for a texture, that may be given instead.
struct SpectrumParam {
    std::string_view name;
    SpectrumType role;
    std::string_view def;  ///< in words, as "the copper of metal-Cu"; Create has the value
    std::string_view doc;
};
/// Points, vectors, normals, and lists of any type.
struct ArrayParam {
    std::string_view name;
    std::string_view type;  ///< of the scene language: "point3", "integer", ...
    std::string_view def;   ///< in words or numbers; Create has the value
    std::string_view doc;
};

using ParamRow = std::variant<FloatParam, IntParam, BoolParam, StringParam, ChoiceParam,
                              SpectrumParam, ArrayParam>;

/// What a plug-in asked for.
struct RequestedParam {
    ParamRow row;
    bool texture = false;  ///< `texture` is allowed, too
};

std::string_view NameOf(const ParamRow &row);
/// The types that a scene may write, "texture" included, as "float or texture".
std::string TypesOf(const RequestedParam &param);
/// Default, range with unit, and meaning, each as the manual shows it; empty where there is none.
std::string DefaultOf(const ParamRow &row);
std::string RangeOf(const ParamRow &row);
std::string_view DocOf(const ParamRow &row);

}  // namespace pbrt
