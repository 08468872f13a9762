#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/matrix.h"

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

/// Standard RGB space: primaries, white, and the map from its colours to spectra.
class RGBColorSpace {
  public:
    /// By pbrt's name, case ignored: srgb, rec2020, dci-p3, aces2065-1; nullptr where unknown.
    static const RGBColorSpace *Named(std::string_view name);
    static const RGBColorSpace &sRGB();
    static std::span<const std::string_view> Names();

    std::string_view Name() const { return name; }
    /// CIE xy of red, green, blue and white (that of Illuminant's spectrum).
    const std::array<std::array<float, 2>, 4> &Chromaticities() const { return xy; }
    const Matrix3 &RGBFromXYZ() const { return rgbFromXYZ; }
    const Matrix3 &XYZFromRGB() const { return xyzFromRGB; }
    RGB ToRGB(const XYZ &c) const;
    XYZ ToXYZ(const RGB &c) const;
    /// Illuminant of the white, its CIE-Y integral not normalised.
    const Spectrum &Illuminant() const { return illuminant; }

    /// Sigmoid whose colour under the illuminant is `rgb`, components clamped to [0, 1]; the
    /// constant for greys. Fitted by Newton's method in 5 to 25 us: once per scene constant, not
    /// per look-up. Components differ by 2e-5 at most wherever a reflectance of that colour
    /// exists (all of sRGB); else, for bright saturated colours of the wider spaces, the nearest
    /// in RGB is sought.
    RGBSigmoid FitSigmoid(const RGB &rgb) const;
    /// The same from a table made at first use (0.2 s on two cores), in 30 ns: for image
    /// textures, per look-up. Components differ by 2e-3 at most in sRGB, 2e-4 on average.
    RGBSigmoid LookUpSigmoid(const RGB &rgb) const;

    Spectrum AlbedoSpectrum(const RGB &rgb) const;      ///< components in [0, 1]
    Spectrum UnboundedSpectrum(const RGB &rgb) const;   ///< components >= 0
    Spectrum IlluminantSpectrum(const RGB &rgb) const;  ///< components >= 0
    /// Per look-up twins of the three above (table instead of fit).
    SampledSpectrum SampleAlbedo(const RGB &rgb, const SampledWavelengths &lambda) const;
    SampledSpectrum SampleUnbounded(const RGB &rgb, const SampledWavelengths &lambda) const;
    SampledSpectrum SampleIlluminant(const RGB &rgb, const SampledWavelengths &lambda) const;

    struct Tables;
    /// The white of `xy` is replaced by that of `illuminant`, so that greys come out exact.
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

/// 3 x 3 matrix that adapts XYZ from one white point (xy) to another, Bradford's method.
Matrix3 WhiteBalance(const std::array<float, 2> &fromXY, const std::array<float, 2> &toXY);

}  // namespace pbrt
