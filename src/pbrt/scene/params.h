#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/scene/param_row.h"
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

/// The parameters of one directive, read by rows. Name and type must match exactly; of several the
/// last of the directive's own counts, else the last inherited. Every getter notes the row it was
/// asked for: so ReportUnused can name what was not read, list what is allowed and suggest the
/// nearest, and Requested() is the plug-in's table. A value that is wrong (count, range) is
/// reported to the diagnostics and the default returned.
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

    /// Outside [row.lo, row.hi] is an error that names value, range and unit.
    float GetOneFloat(const FloatParam &row);
    int GetOneInt(const IntParam &row);
    bool GetOneBool(const BoolParam &row);
    std::string GetOneString(const StringParam &row);
    /// One of `allowed`, else an error that lists them; returns its index in `allowed`.
    int GetOneChoice(const ChoiceParam &row);
    Point3f GetOnePoint3f(const PointParam &row);
    Vector3f GetOneVector3f(const PointParam &row);
    /// Spectrum of rgb, blackbody or spectrum (inline, named, file); nullopt if not given or wrong.
    /// Of these types the last one written counts. rgb: below 0, or above 1 for Albedo, is an
    /// error. Outside their wavelengths spectra are 0, as in pbrt-v4, but measurements in files:
    /// there albedos and unbounded ones keep the end's value, with one warning a file.
    std::optional<Spectrum> GetOneSpectrum(const SpectrumParam &row);
    /// The RGB itself where the value that counts (see above) was given as `rgb`.
    std::optional<RGB> GetOneRGB(const SpectrumParam &row);
    /// File name, made relative to the scene's folder where such a file exists; empty if not given.
    /// A file that does not exist is an error, and further ones at its place are none.
    std::string GetFileName(const StringParam &row);

    // Whole arrays; empty where not given or wrong. Points and vectors: count a multiple of theirs.
    // The row's type is the getter's.
    std::vector<float> GetFloatArray(const ArrayParam &row);
    std::vector<int> GetIntArray(const ArrayParam &row);
    std::vector<Point2f> GetPoint2fArray(const ArrayParam &row);
    std::vector<Point3f> GetPoint3fArray(const ArrayParam &row);
    std::vector<Vector3f> GetVector3fArray(const ArrayParam &row);
    std::vector<Normal3f> GetNormalArray(const ArrayParam &row);
    std::vector<std::string> GetStringArray(const ArrayParam &row);

    /// The texture's name where `"texture name"` was given (the caller resolves it) and no later
    /// constant of that name overrides it. Ask for it before the constant.
    std::optional<std::string> GetTexture(const ParamRow &row);
    /// True where a value of the row's types was given; does not count as reading it, but as
    /// knowing the name. HasOrTexture: where a texture was given, too.
    bool Has(const ParamRow &row);
    bool HasOrTexture(const ParamRow &row);
    /// True where a parameter of that name was given, of whatever type: a wrong one is an error of
    /// its own.
    bool IsNamed(std::string_view name) const { return FindLast(name, {}).has_value(); }
    /// The rows that were asked for, each once, in that order; those of one name stand together (a
    /// parameter may be a float or a spectrum).
    const std::vector<RequestedParam> &Requested() const { return requested; }

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
    using Types = std::span<const std::string_view>;

    /// The value of the row that counts, marked as used; nullptr where not given.
    const ParsedParameter *Find(const ParamRow &row);
    /// The same for a single value made of `items` tokens; nullptr also where the count is wrong.
    const ParsedParameter *FindOne(const ParamRow &row, size_t items);
    /// Index of the parameter that counts among those of these types (any, if none are given).
    std::optional<size_t> FindLast(std::string_view name, Types types) const;
    void NoteRequest(const ParamRow &row, bool texture = false);
    bool CountIs(const ParsedParameter &p, size_t count);
    /// The values in groups of `items`, of which a wrong count leaves out the last.
    const std::vector<float> *FindGroups(const ArrayParam &row, size_t items);
    template <typename Value>
    std::vector<Value> Triples(const ArrayParam &row);
    /// False, with an error, where `whyIllegal` is not empty.
    bool Allow(const ParsedParameter &p, const std::string &whyIllegal);
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
    std::vector<RequestedParam> requested;
    FileLoc directive;
    std::string what;
    const RGBColorSpace *colorSpace;
    Diagnostics *diagnostics;
    std::string dir;
};

/// Default value, used where the parameter is not given; only of rows whose `def` is a number or
/// the name of a built-in spectrum.
Spectrum DefaultSpectrum(const SpectrumParam &row);

}  // namespace pbrt
