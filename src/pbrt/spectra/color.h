#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "pbrt/spectra/spectrum.h"

namespace pbrt {

struct RGB {
    float r = 0, g = 0, b = 0;
    float operator[](int i) const { return i == 0 ? r : (i == 1 ? g : b); }
    float &operator[](int i) { return i == 0 ? r : (i == 1 ? g : b); }
    friend RGB operator+(RGB a, RGB b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
    friend RGB operator*(RGB a, float s) { return {a.r * s, a.g * s, a.b * s}; }
    bool operator==(const RGB &) const = default;
    float Average() const { return (r + g + b) / 3; }
    float Max() const { return std::max(r, std::max(g, b)); }
};

using Matrix3 = std::array<std::array<float, 3>, 3>;  ///< [row][column]
std::array<float, 3> Mul(const Matrix3 &m, const std::array<float, 3> &v);

/// Standard RGB space: primaries, white, and the map from its colours to spectra.
class RGBColorSpace {
  public:
    /// By pbrt's name, case ignored: srgb, rec2020, dci-p3, aces2065-1; nullptr where unknown.
    static const RGBColorSpace *Named(std::string_view name);
    static const RGBColorSpace &sRGB();
    static std::span<const std::string_view> Names();

    std::string_view Name() const { return name; }
    /// CIE xy of red, green, blue and white.
    const std::array<std::array<float, 2>, 4> &Chromaticities() const { return xy; }
    const Matrix3 &RGBFromXYZ() const { return rgbFromXYZ; }
    const Matrix3 &XYZFromRGB() const { return xyzFromRGB; }
    RGB ToRGB(const XYZ &c) const;
    XYZ ToXYZ(const RGB &c) const;
    /// Illuminant of the white, its CIE-Y integral not normalised.
    const Spectrum &Illuminant() const { return illuminant; }

    /// Sigmoid whose colour under the illuminant is `rgb`, components in [0, 1]. Fitted by Newton's
    /// method; costs microseconds: once per scene constant, not per look-up.
    RGBSigmoid FitSigmoid(const RGB &rgb) const;
    /// The same from a table made at first use: for image textures, per look-up.
    RGBSigmoid LookUpSigmoid(const RGB &rgb) const;

    Spectrum AlbedoSpectrum(const RGB &rgb) const;      ///< components in [0, 1]
    Spectrum UnboundedSpectrum(const RGB &rgb) const;   ///< components >= 0
    Spectrum IlluminantSpectrum(const RGB &rgb) const;  ///< components >= 0
    /// Per look-up twins of the three above (table instead of fit).
    SampledSpectrum SampleAlbedo(const RGB &rgb, const SampledWavelengths &lambda) const;
    SampledSpectrum SampleUnbounded(const RGB &rgb, const SampledWavelengths &lambda) const;
    SampledSpectrum SampleIlluminant(const RGB &rgb, const SampledWavelengths &lambda) const;

    struct Tables;
    RGBColorSpace(std::string_view name, const std::array<std::array<float, 2>, 4> &xy,
                  const Spectrum &illuminant);
    ~RGBColorSpace();

  private:
    std::string_view name;
    std::array<std::array<float, 2>, 4> xy;
    Matrix3 rgbFromXYZ, xyzFromRGB;
    Spectrum illuminant;
    std::unique_ptr<Tables> tables;
};

/// sRGB transfer curve; linear in [0, 1] to encoded and back.
float LinearToSRGB(float linear);
float SRGBToLinear(float encoded);
/// 3 x 3 matrix that adapts XYZ from one white point (xy) to another, Bradford's method.
Matrix3 WhiteBalance(const std::array<float, 2> &fromXY, const std::array<float, 2> &toXY);

}  // namespace pbrt
