#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pbrt::feathergen {

/// Parameters of a feather. Lengths in millimetres, angles in radians; meaning, range and default
/// of each stand in ParameterTable(), which also sets the initial values.
struct Parameters {
    double rachisLength, rachisBend, rachisSweep, rachisRadius, rachisTipRadius;
    double barbCount, barbStart, barbCrowding;
    double barbLength, barbLengthBase, barbLengthTip, barbLengthPeak;
    double barbAngleBase, barbAngleTip, barbLift, barbDroop, barbCurl, barbRoll, jitter;
    double barbWidth, barbTaper, barbTipWidth, cover, span, ramusRadius;
    double thickness, thicknessSpread, thicknessGradient, thicknessAlong;
    double spacing, spacingSpread, spacingGradient, spacingAlong;
    double tilt, tiltSpread, tiltGradient, tiltAlong, tiltRise, tiltRiseWidth;
    double aspect, opening;
    double keratinRed, keratinGreen, keratinBlue;
    double quadsAlong, quadsAcross, tubeSides, rachisSegments;
    double neckSpacing, neckShapes, neckSizeTop, neckSizeBottom, neckJitter;
    double neckPitch, neckClearance, neckBorder, neckBorderWidth;
    double neckGreen, neckPurple;

    Parameters();
    /// Quads in the vane of one feather.
    double VaneQuads() const { return 4 * barbCount * quadsAlong * quadsAcross; }
    bool operator==(const Parameters &) const = default;
};

/// More quads of vane in a feather are refused: they would not fit in memory.
inline constexpr double kMostVaneQuads = 1e7;

/// One line of the table that --help, --print-preset, --params and the messages read.
struct FloatParam {
    std::string_view name, unit;
    double Parameters::*value;
    double def, lo, hi;  ///< default and legal range, both ends included
    std::string_view doc;
    bool whole = false;  ///< a count
};

std::span<const FloatParam> ParameterTable();

/// Sets the parameter called `name`. A name that is not in the table, a value outside its range or
/// a count that is not whole is returned as a sentence, and nothing is set.
std::string SetParameter(std::string_view name, double value, Parameters *parameters);

/// A ready feather, by what it changes of the defaults.
struct Preset {
    struct Change {
        double Parameters::*value;
        double to;
    };
    std::string_view name, doc;
    std::span<const Change> changes;
};
std::span<const Preset> Presets();
/// The preset's parameters; where there is none of that name, `problem` says so.
Parameters PresetNamed(std::string_view name, std::string *problem);

/// The table as text for --help: name, unit, range, default, meaning.
std::string ParameterManual();

/// All parameters as a JSON object, one a line, in the table's order.
std::string ToJson(const Parameters &parameters);
/// Changes those of `parameters` that the JSON object in `text` names. Returns what is wrong with
/// it (all mistakes, a line each, without the file's name), or nothing; then only is anything
/// changed.
std::string FromJson(std::string_view text, Parameters *parameters);

}  // namespace pbrt::feathergen
