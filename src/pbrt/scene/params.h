#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/spectra/color.h"
#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/diagnostics.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// One `"type name" [ values ]` as written. Only the vector that the type calls for is filled; none
/// where the values were wrong, which has been reported: getters then return the default silently.
struct ParsedParameter {
    std::string_view type;  ///< one of the language's; text that lives for ever
    std::string name;
    FileLoc loc;       ///< of the quoted declaration
    FileLoc valueLoc;  ///< of the first value
    std::vector<float> floats;
    std::vector<int> ints;
    std::vector<std::string> strings;
    std::vector<uint8_t> bools;
    bool mayBeUnused = false;                   ///< inherited from an Attribute directive
    const RGBColorSpace *colorSpace = nullptr;  ///< of `rgb` values
};

using ParsedParameters = std::vector<ParsedParameter>;

/// How an RGB colour becomes a spectrum.
enum class SpectrumType { Albedo, Unbounded, Illuminant };

/// A number's name, unit, default, range and meaning: one row of a plug-in's table. The same rows
/// feed parsing, range errors, the manual (--help-plugin) and the tests' corner cases.
struct FloatParam {
    std::string_view name, unit;
    float def, lo, hi;
    std::string_view doc;
};

/// The parameters of one directive, read by name. Name and type must match exactly; of several the
/// last of the directive's own counts, else the last inherited. Every getter notes the name it was
/// asked for, so ReportUnused can name what was not read, list what is allowed and suggest the
/// nearest. A value that is wrong (count, range) is reported to the diagnostics and the default
/// returned.
class ParamDict {
  public:
    /// `what` says whose parameters these are, e.g. `material "diffuse"`. `params`: the directive's
    /// own in file order, then inherited ones; they must outlive the dictionary. `dir`: folder that
    /// relative file names start from.
    ParamDict(const ParsedParameters &params, FileLoc directive, std::string what,
              const RGBColorSpace *colorSpace, Diagnostics *diagnostics, std::string dir = "");
    /// The same with parameters of its own.
    ParamDict(ParsedParameters &&params, FileLoc directive, std::string what,
              const RGBColorSpace *colorSpace, Diagnostics *diagnostics, std::string dir = "");

    float GetOneFloat(std::string_view name, float def);
    /// Range-checked: outside [row.lo, row.hi] is an error that names value, range and unit.
    float GetOneFloat(const FloatParam &row);
    int GetOneInt(std::string_view name, int def);
    /// Range-checked as above.
    int GetOneInt(std::string_view name, int def, int lo, int hi);
    bool GetOneBool(std::string_view name, bool def);
    std::string GetOneString(std::string_view name, std::string_view def);
    /// One of `allowed`, else an error that lists them; returns its index in `allowed`.
    int GetOneChoice(std::string_view name, std::string_view def,
                     std::span<const std::string_view> allowed);
    Point2f GetOnePoint2f(std::string_view name, Point2f def);
    Point3f GetOnePoint3f(std::string_view name, Point3f def);
    Vector3f GetOneVector3f(std::string_view name, Vector3f def);
    /// From rgb, blackbody or spectrum (inline, named, file); nullopt where not given or wrong.
    /// Of these types the last one written counts. rgb: below 0, or above 1 for Albedo, is an
    /// error. Outside their wavelengths spectra are 0, as in pbrt-v4, but measurements in files:
    /// there albedos and unbounded ones keep the end's value, with one warning a file.
    std::optional<Spectrum> GetOneSpectrum(std::string_view name, SpectrumType role);
    /// The RGB itself where the parameter was given as `rgb`.
    std::optional<RGB> GetOneRGB(std::string_view name);
    /// File name, made relative to the scene's folder where such a file exists; empty if not given.
    std::string GetFileName(std::string_view name, std::string_view def = "");

    // Whole arrays; empty where not given or wrong. Points and vectors: count a multiple of theirs.
    std::vector<float> GetFloatArray(std::string_view name);
    std::vector<int> GetIntArray(std::string_view name);
    std::vector<Point2f> GetPoint2fArray(std::string_view name);
    std::vector<Point3f> GetPoint3fArray(std::string_view name);
    std::vector<Vector3f> GetVector3fArray(std::string_view name);
    std::vector<Normal3f> GetNormalArray(std::string_view name);
    std::vector<std::string> GetStringArray(std::string_view name);

    /// The texture's name where `"texture name"` was given (the caller resolves it) and no later
    /// constant of that name overrides it. Ask for it before the constant.
    std::optional<std::string> GetTexture(std::string_view name);
    /// True where a parameter of this name, and of this type unless empty, was given; does not
    /// count as reading it, but as knowing the name.
    bool Has(std::string_view name, std::string_view type = "");

    /// Place of the named parameter's declaration (the directive's where it was not given).
    FileLoc Loc(std::string_view name) const;
    const FileLoc &Directive() const { return directive; }
    const std::string &What() const { return what; }
    const RGBColorSpace &ColorSpace() const { return *colorSpace; }
    const std::string &Dir() const { return dir; }
    /// An error at the named parameter (at the directive where it was not given); nothing is added
    /// to the message.
    void Error(std::string_view name, std::string_view message);
    void Warning(std::string_view name, std::string_view message);
    /// See Diagnostics::WarningOnce.
    void WarningOnce(std::string_view name, std::string_view message);
    /// An error at the directive.
    void Error(std::string_view message);
    Diagnostics &Log() { return *diagnostics; }
    /// Errors for parameters nobody read: wrong type if the name is known, else unknown name with
    /// the known ones and the nearest.
    void ReportUnused();

  private:
    /// Types a name may have, for slots that take several.
    using Types = std::initializer_list<std::string_view>;
    struct Request {
        std::string name;
        std::string_view type;  ///< empty: any
    };

    /// The one of these types that counts, marked as used; nullptr where not given.
    const ParsedParameter *Find(std::string_view name, Types types);
    /// The same for a single value made of `items` tokens; nullptr also where the count is wrong.
    const ParsedParameter *FindOne(std::string_view name, std::string_view type, size_t items);
    /// Index of the parameter that counts among those of these types (any, if none are given).
    std::optional<size_t> FindLast(std::string_view name, Types types) const;
    void NoteRequest(std::string_view name, std::string_view type);
    bool CountIs(const ParsedParameter &p, size_t count);
    /// The values in groups of `items`, of which a wrong count leaves out the last.
    const std::vector<float> *FindGroups(std::string_view name, std::string_view type,
                                         size_t items);
    template <typename Value>
    std::vector<Value> Triples(std::string_view name, std::string_view type);
    template <typename Number>
    bool InRange(const ParsedParameter &p, Number value, Number lo, Number hi,
                 std::string_view unit);
    std::optional<RGB> CheckedRGB(const ParsedParameter &p, float most);
    std::optional<Spectrum> FromRGB(const ParsedParameter &p, SpectrumType role);
    std::optional<Spectrum> FromBlackbody(const ParsedParameter &p);
    std::optional<Spectrum> FromPairs(const ParsedParameter &p);
    std::optional<Spectrum> FromNameOrFile(const ParsedParameter &p, SpectrumType role);
    /// An error about the value of `p`, at the value.
    void ValueError(const ParsedParameter &p, std::string_view message);
    void ReportUnused(const ParsedParameter &p, size_t index);

    std::shared_ptr<const ParsedParameters> own;
    std::span<const ParsedParameter> params;
    std::vector<uint8_t> used;
    std::vector<Request> asked;  ///< in order, each once
    FileLoc directive;
    std::string what;
    const RGBColorSpace *colorSpace;
    Diagnostics *diagnostics;
    std::string dir;
};

}  // namespace pbrt
