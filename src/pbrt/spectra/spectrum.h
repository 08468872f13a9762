#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "pbrt/spectra/sampled_spectrum.h"

namespace pbrt {

/// s(lambda) = 1/2 + x / (2 sqrt(1 + x^2)), x = (c0 lambda + c1) lambda + c2 with lambda in nm:
/// a smooth spectrum in [0, 1] (Jakob and Hanika 2019). c2 = +-infinity gives exactly 1 or 0.
struct RGBSigmoid {
    float c0 = 0, c1 = 0, c2 = 0;
    float operator()(float lambda) const;
    SampledSpectrum Sample(const SampledWavelengths &lambda) const;
    float MaxValue() const;
};

/// Values at every whole nm from 360 to 830, linear between, 0 outside.
struct DenseTable {
    std::vector<float> values;  ///< 471 of them
    float operator()(float lambda) const;
};

/// A spectral distribution over wavelengths in nm. A small value; tables are shared, immutable.
class Spectrum {
  public:
    enum class Kind : uint8_t { Constant, Sigmoid, SigmoidTimesTable, Dense, PiecewiseLinear };

    Spectrum() : Spectrum(0.f) {}
    explicit Spectrum(float constant) : kind(Kind::Constant), scale(constant) {}
    /// scale * sigmoid(lambda): scale 1 for albedos, any for unbounded colours.
    explicit Spectrum(RGBSigmoid sigmoid, float scale = 1)
        : kind(Kind::Sigmoid), scale(scale), sigmoid(sigmoid) {}
    /// scale * sigmoid(lambda) * table(lambda): an RGB colour under an illuminant.
    Spectrum(RGBSigmoid sigmoid, float scale, std::shared_ptr<const DenseTable> illuminant);
    static Spectrum Dense(std::shared_ptr<const DenseTable> table, float scale = 1);
    /// Lambda strictly increasing; linear between, zero outside. Exact, slower than Dense.
    static Spectrum PiecewiseLinear(std::span<const float> lambda, std::span<const float> values);
    /// Planck radiance at T kelvin, scaled to peak 1; T > 0.
    static Spectrum Blackbody(float kelvin);

    float operator()(float lambda) const;
    SampledSpectrum Sample(const SampledWavelengths &lambda) const;
    float MaxValue() const;
    bool IsConstant() const { return kind == Kind::Constant; }
    /// This spectrum times s.
    Spectrum Scaled(float s) const;
    /// The same in a table of 471 values: faster for lights. Illuminants round to whole nm.
    Spectrum Densely() const;

  private:
    struct Points {
        std::vector<float> lambda, values;
    };
    Kind kind;
    float scale = 1;
    RGBSigmoid sigmoid;
    std::shared_ptr<const DenseTable> table;
    std::shared_ptr<const Points> points;
};

/// Integral of s times the CIE 1931 y matching function over 360-830 nm (1 nm sums).
float SpectrumToPhotometric(const Spectrum &s);
/// Integral of a(lambda) b(lambda).
float InnerProduct(const Spectrum &a, const Spectrum &b);
/// CIE XYZ of a spectrum, Y of the constant 1 being 1.
struct XYZ {
    float X = 0, Y = 0, Z = 0;
};
XYZ SpectrumToXYZ(const Spectrum &s);

namespace spectra {
// CIE 1931 2 degree observer at whole nm, 471 values each.
const Spectrum &X();
const Spectrum &Y();
const Spectrum &Z();
}  // namespace spectra

/// Named spectra of PBRT_FORMAT 2.12 (metal-*, glass-*, stdillum-*, illum-acesD60) and `keratin`,
/// `melanin` (MODEL section 2); nullptr where there is none.
const Spectrum *GetNamedSpectrum(std::string_view name);
std::span<const std::string_view> NamedSpectrumNames();

}  // namespace pbrt
