#include "pbrt/feather/params.h"
#include "pbrt/feathergen/parameters.h"

namespace pbrt::feathergen {
namespace {

using P = Parameters;
using feather::ParamNamed;

// Sizes of a rock dove's neck feather, and MODEL's figures for barbs: a strip of a cylinder of half
// opening angle 0.78, barbules at 0.45 to the barb, width 0.015 of the feather, taper over the last
// 40 %, tilt up to 0.5 higher within 10 % of the ramus.
constexpr FloatParam kTable[] = {
    {"rachis_length", "mm", &P::rachisLength, 24, 1, 1000, "length of the rachis"},
    {"rachis_bend", "rad", &P::rachisBend, 0.05, -3, 3, "how far the tip bends down"},
    {"rachis_sweep", "rad", &P::rachisSweep, 0.05, -3, 3, "how far the tip bends to the right"},
    {"rachis_radius", "mm", &P::rachisRadius, 0.14, 0.001, 20, "radius at the root"},
    {"rachis_tip_radius", "mm", &P::rachisTipRadius, 0.02, 0.001, 20, "radius at the tip"},

    {"barb_count", "", &P::barbCount, 46, 2, 2000, "barbs on each side", true},
    {"barb_start", "", &P::barbStart, 0.28, 0, 0.95, "part of the rachis below the first barb"},
    {"barb_crowding", "", &P::barbCrowding, 0.25, -0.9, 0.9,
     "how much closer than the mean barbs stand at the tip, and wider at the base"},
    {"barb_length", "mm", &P::barbLength, 8.5, 0.1, 500, "length of the longest barb"},
    {"barb_length_base", "", &P::barbLengthBase, 0.75, 0.01, 1, "first barb's part of that"},
    {"barb_length_tip", "", &P::barbLengthTip, 0.5, 0.01, 1, "last barb's part of that"},
    {"barb_length_peak", "", &P::barbLengthPeak, 0.4, 0.01, 0.99,
     "where the longest barb stands between the first (0) and the last (1)"},
    {"barb_angle_base", "rad", &P::barbAngleBase, 0.75, 0, 1.57,
     "angle between rachis and first barb"},
    {"barb_angle_tip", "rad", &P::barbAngleTip, 0.1, 0, 1.57, "angle between rachis and last barb"},
    {"barb_lift", "rad", &P::barbLift, 0.1, -1.5, 1.5, "how steeply barbs rise at the rachis"},
    {"barb_droop", "rad", &P::barbDroop, 0.35, -3, 3, "how far barbs bend down on their way"},
    {"barb_curl", "rad", &P::barbCurl, 0.35, -3, 3,
     "how far the first barb bends to the feather's tip; others as their angles are"},
    {"barb_roll", "rad", &P::barbRoll, 0, -1.5, 1.5,
     "turn of barbs about themselves, the side to the feather's tip down"},
    {"jitter", "rad", &P::jitter, 0.025, 0, 0.5,
     "spread of the barbs' angles; of their lengths and widths in parts"},

    {"barb_width", "mm", &P::barbWidth, 0.4, 0.001, 50, "width of a barb with both its banks"},
    {"barb_taper", "", &P::barbTaper, 0.4, 0.01, 1, "part of a barb over which it tapers"},
    {"barb_tip_width", "", &P::barbTipWidth, 0.12, 0.01, 1, "width at a barb's tip, of its width"},
    {"cover", "rad", &P::cover, 0.78, 0.01, 1.5, "half opening angle of a barb's cylinder"},
    {"span", "rad", &P::span, 0.45, 0, 1.5, "angle between barbules and barb"},
    {"ramus_radius", "mm", &P::ramusRadius, 0.013, 0.0005, 5, "radius of a barb's ramus"},

    {"thickness", "nm", &P::thickness, 562, 0, 1e6, "keratin film, in the middle of the feather"},
    {"thickness_spread", "nm", &P::thicknessSpread, 5, 0, 1e5, "standard deviation between barbs"},
    {"thickness_gradient", "nm", &P::thicknessGradient, 66, -1e5, 1e5, "last barb less first"},
    {"thickness_along", "nm", &P::thicknessAlong, 10, -1e5, 1e5, "a barb's tip less its root"},
    {"spacing", "", &P::spacing, ParamNamed("spacing").def, 0.01, 1e4,
     "barbules' distance in half-widths"},
    {"spacing_spread", "", &P::spacingSpread, 0.03, 0, 1e3, "standard deviation between barbs"},
    {"spacing_gradient", "", &P::spacingGradient, 0, -1e3, 1e3, "last barb less first"},
    {"spacing_along", "", &P::spacingAlong, 0.1, -1e3, 1e3, "a barb's tip less its root"},
    {"tilt", "rad", &P::tilt, ParamNamed("tilt").def, -1.57, 1.57, "of the barbules' sections"},
    {"tilt_spread", "rad", &P::tiltSpread, 0.03, 0, 1, "standard deviation between barbs"},
    {"tilt_gradient", "rad", &P::tiltGradient, 0, -3, 3, "last barb less first"},
    {"tilt_along", "rad", &P::tiltAlong, 0, -3, 3, "a barb's tip less its root"},
    {"tilt_rise", "rad", &P::tiltRise, 0.5, -3, 3, "added to the tilt at the ramus"},
    {"tilt_rise_width", "", &P::tiltRiseWidth, 0.1, 0.001, 1,
     "part of the bank over which that fades away"},
    {"aspect", "", &P::aspect, ParamNamed("aspect").def, 0.001, 1000, "barbules' height by width"},
    {"opening", "rad", &P::opening, ParamNamed("opening").def, 0, 1.5, "barbules' bend"},

    {"keratin_red", "", &P::keratinRed, 0.17, 0, 1, "reflectance of rachis and rami"},
    {"keratin_green", "", &P::keratinGreen, 0.115, 0, 1, "reflectance of rachis and rami"},
    {"keratin_blue", "", &P::keratinBlue, 0.075, 0, 1, "reflectance of rachis and rami"},

    {"quads_along", "", &P::quadsAlong, 32, 2, 1000, "quads along a barb", true},
    {"quads_across", "", &P::quadsAcross, 6, 1, 200, "quads across a bank", true},
    {"tube_sides", "", &P::tubeSides, 5, 3, 64, "sides of rami; the rachis has twice as many",
     true},
    {"rachis_segments", "", &P::rachisSegments, 64, 2, 1000, "quads along the rachis", true},

    {"neck_spacing", "mm", &P::neckSpacing, 3.9, 0.1, 1000, "least distance of feathers' roots"},
    {"neck_shapes", "", &P::neckShapes, 3, 1, 32, "distinct feathers of each color", true},
    {"neck_size_top", "", &P::neckSizeTop, 0.6, 0.01, 100,
     "size of feathers where the flow begins"},
    {"neck_size_bottom", "", &P::neckSizeBottom, 1, 0.01, 100, "and where it ends"},
    {"neck_jitter", "rad", &P::neckJitter, 0.06, 0, 1, "spread of directions; of sizes in parts"},
    {"neck_pitch", "rad", &P::neckPitch, 0.03, -1, 1, "angle of a feather with nothing under it"},
    {"neck_clearance", "mm", &P::neckClearance, 0.12, 0, 100, "least distance of feathers"},
    {"neck_border", "", &P::neckBorder, 0.45, -1, 2, "where green turns purple, of the flow's way"},
    {"neck_border_width", "", &P::neckBorderWidth, 0.3, 0.001, 10, "and over what part of it"},
    {"neck_green", "nm", &P::neckGreen, 594, 0, 1e6, "film thickness of the green zone"},
    {"neck_purple", "nm", &P::neckPurple, 532, 0, 1e6, "film thickness of the purple zone"},
};

// Cortex thicknesses: 595 nm is green, 530 nm purple (PHYSICS, after Yu et al. 2024).
constexpr Preset::Change kGreen[] = {{&P::thickness, 592}, {&P::thicknessGradient, 12}};
constexpr Preset::Change kPurple[] = {{&P::thickness, 532}, {&P::thicknessGradient, 8}};

constexpr Preset kPresets[] = {
    {"rock-dove-neck", "green tip, purple base", {}},
    {"rock-dove-green", "green all over", kGreen},
    {"rock-dove-purple", "purple all over", kPurple},
};

}  // namespace

std::span<const FloatParam> ParameterTable() {
    return kTable;
}

std::span<const Preset> Presets() {
    return kPresets;
}

}  // namespace pbrt::feathergen
