#pragma once

#include <array>
#include <concepts>
#include <numbers>
#include <string_view>

#include "units.h"

namespace pbrt::feather {

enum class Unit { None, Nanometre, Radian, Degree };

/// Unit as an error message or the manual writes it after a value.
constexpr std::string_view UnitName(Unit unit) {
    switch (unit) {
        case Unit::Nanometre:
            return "nm";
        case Unit::Radian:
            return "rad";
        case Unit::Degree:
            return "deg";
        default:
            return "";
    }
}

/// One numeric parameter of `Material "featherbarbule"`.
struct FloatParam {
    std::string_view name;
    Unit unit;
    double def, lo, hi;  ///< default and legal range, both ends included
    std::string_view doc;
    constexpr bool Legal(double value) const { return lo <= value && value <= hi; }
};

/// One spectral parameter; `def` names a spectrum of dispersion.h.
struct SpectrumParam {
    std::string_view name, def;
    bool texture;   ///< whether it may vary over the surface
    double lo, hi;  ///< legal range at every wavelength
    std::string_view doc;
};

/// The tables of MODEL section 2: parsing, range errors, the manual and the tests' corners read
/// them. Each of kParams may be a float texture.
inline constexpr std::array<FloatParam, 10> kParams{{
    {"thickness", Unit::Nanometre, 590, 0, 1e6, "thickness of the keratin film"},
    {"spacing", Unit::None, 1.25, 0.01, 1e4,
     "distance between neighbouring barbules, in half-widths of a barbule"},
    {"tilt", Unit::Radian, -0.35, -std::numbers::pi / 2, std::numbers::pi / 2,
     "rotation of the cross-section about the barbule's axis"},
    {"aspect", Unit::None, 0.25, 0.001, 1000,
     "semi-axis of the cross-section along the barbule's own normal; the other one is 1"},
    {"opening", Unit::Radian, 0.0785, 0, 1.5,
     "half opening angle of the circular arc that the barbule makes along its length"},
    {"rotation", Unit::Degree, 0, -1e4, 1e4, "turns the barbules about the surface normal"},
    {"filmroughness", Unit::Nanometre, 0, 0, 1e4,
     "standard deviation of the film's thickness within a few micrometres"},
    {"cellthickness", Unit::Nanometre, 0, 0, 1e4,
     "standard deviation of `thickness` from cell to cell"},
    {"celltilt", Unit::Radian, 0, 0, 0.3, "standard deviation of `tilt` from cell to cell"},
    {"cellbend", Unit::Radian, 0, 0, 0.3,
     "standard deviation, from cell to cell, of a turn about the axis across the barbules"},
}};

/// The grid of cells: numbers that are the same all over the surface.
inline constexpr std::array<FloatParam, 3> kCellParams{{
    {"cellsacross", Unit::None, 0, 0, 1e6, "cells for one unit of u; 0: no cells"},
    {"cellsalong", Unit::None, 0, 0, 1e6, "cells for one unit of v; 0: no cells"},
    {"cellshear", Unit::None, 0, -1e3, 1e3,
     "u that one unit of v is worth: slant of the cells' rows"},
}};

inline constexpr std::array<SpectrumParam, 2> kSpectrumParams{{
    {"eta", "keratin", false, 1, 1e3, "refractive index of the film"},
    {"melanin", "melanin", true, 0, 1, "diffuse reflectance of the melanin under the film"},
}};

/// The entry of kParams called `name`, which must be in the table.
constexpr const FloatParam &ParamNamed(std::string_view name) {
    const FloatParam *found = kParams.data();
    while (found->name != name)
        ++found;
    return *found;
}

/// The shape of a patch of vane and its film; values within kParams' ranges (the caller checks).
template <std::floating_point T>
struct BarbuleParams {
    Nm<T> thickness{T(ParamNamed("thickness").def)};
    Nm<T> filmRoughness{T(ParamNamed("filmroughness").def)};
    T spacing = T(ParamNamed("spacing").def);
    Radian<T> tilt{T(ParamNamed("tilt").def)};
    T aspect = T(ParamNamed("aspect").def);
    Radian<T> opening{T(ParamNamed("opening").def)};
};

/// Values that depend on wavelength, for the N wavelengths that are evaluated together.
template <class V, int N>
struct Optics {
    std::array<V, N> lambda;   ///< vacuum wavelength, nm, > 0
    std::array<V, N> eta;      ///< index of the film, >= 1
    std::array<V, N> melanin;  ///< diffuse reflectance of the melanin, [0, 1]
};

}  // namespace pbrt::feather
