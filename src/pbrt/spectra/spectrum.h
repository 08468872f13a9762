#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/check.h"

namespace pbrt {

/// s(lambda) = 1/2 + x / (2 sqrt(1 + x^2)), x = (c0 lambda + c1) lambda + c2 with lambda in nm:
/// a smooth spectrum in [0, 1] (Jakob and Hanika 2019). c2 = +-infinity gives exactly 1 or 0.
struct RGBSigmoid {
    float c0 = 0, c1 = 0, c2 = 0;
    float operator()(float lambda) const { return AtAll(SampledSpectrum(lambda))[0]; }
    SampledSpectrum Sample(const SampledWavelengths &lambda) const {
        return AtAll(lambda.Lambda());
    }
    /// Greatest value in [LambdaMin, LambdaMax].
    float MaxValue() const;

  private:
    SampledSpectrum AtAll(SampledSpectrum lambda) const;
};

/// Values at every whole nm from 360 to 830, linear between, 0 outside.
struct DenseTable {
    static constexpr int Size = 471;
    std::vector<float> values;  ///< Size of them
    float operator()(float lambda) const { return Sample(SampledSpectrum(lambda))[0]; }
    SampledSpectrum Sample(SampledSpectrum lambda) const;
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
    /// `f(lambda)` at every whole nm from 360 to 830.
    template <typename F>
    static Spectrum DenselySampled(F f);
    /// Lambda strictly increasing, as many values; linear between, zero outside. Exact, slower
    /// than Dense.
    static Spectrum PiecewiseLinear(std::span<const float> lambda, std::span<const float> values);
    /// Planck radiance at T kelvin, scaled to peak 1 (at 2897772 / T nm, wherever that is); T > 0.
    static Spectrum Blackbody(float kelvin);
    /// CIE daylight of correlated colour temperature 4000 to 25000 K, 100 at 560 nm (CIE 015).
    static Spectrum Daylight(double kelvin);

    float operator()(float lambda) const;
    SampledSpectrum Sample(const SampledWavelengths &lambda) const;
    /// Greatest value in [LambdaMin, LambdaMax], that of whole nm where a table takes part.
    float MaxValue() const;
    bool IsConstant() const { return kind == Kind::Constant; }
    /// This spectrum times s >= 0.
    Spectrum Scaled(float s) const;
    /// The same in a table of 471 values: faster for lights. Illuminants round to whole nm.
    Spectrum Densely() const;

  private:
    struct Points {
        std::vector<float> lambda, values;
        float operator()(float at) const;
    };
    SampledSpectrum SamplePoints(SampledSpectrum lambda) const;

    Kind kind;
    float scale = 1;
    RGBSigmoid sigmoid;
    std::shared_ptr<const DenseTable> table;
    std::shared_ptr<const Points> points;
};

/// Planck's spectral radiance in W / (m^2 sr m) at `lambda` nm and `kelvin`, both > 0.
double BlackbodyRadiance(double lambda, double kelvin);

/// CIE xy of daylight of correlated colour temperature 4000 to 25000 K (CIE 015).
std::array<double, 2> DaylightChromaticity(double kelvin);

/// Integral of s times the CIE 1931 y matching function over 360-830 nm (1 nm sums).
float SpectrumToPhotometric(const Spectrum &s);
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

// Hot paths.

[[gnu::always_inline]] inline SampledSpectrum RGBSigmoid::AtAll(SampledSpectrum lambda) const {
    const FloatX4 l = lambda.Values();
    const FloatX4 polynomial = (c0 * l + c1) * l + c2;
    // Beyond 2^30 the quotient is 1 in float anyway; infinity would give inf / inf.
    const FloatX4 x = Clamp(polynomial, -0x1p30f, 0x1p30f);
    return SampledSpectrum(0.5f + 0.5f * (x / Sqrt(1 + x * x)));
}

[[gnu::always_inline]] inline SampledSpectrum DenseTable::Sample(SampledSpectrum lambda) const {
    const FloatX4 x = lambda.Values() - LambdaMin;
    const auto inside = (x >= 0) & (x <= float(Size - 1));
    const FloatX4 safe = Select(inside, x, 0);
    const IntX4 i = Min(Convert<int32_t>(safe), Size - 2);
    const FloatX4 t = safe - Convert<float>(i);
    const float *v = values.data();
    const FloatX4 a{v[i[0]], v[i[1]], v[i[2]], v[i[3]]};
    const FloatX4 b{v[i[0] + 1], v[i[1] + 1], v[i[2] + 1], v[i[3] + 1]};
    return SampledSpectrum(Select(inside, a + t * (b - a), 0));
}

[[gnu::always_inline]] inline SampledSpectrum Spectrum::Sample(
    const SampledWavelengths &lambda) const {
    switch (kind) {
        case Kind::Constant:
            return SampledSpectrum(scale);
        case Kind::Sigmoid:
            return sigmoid.Sample(lambda) * scale;
        case Kind::SigmoidTimesTable:
            return sigmoid.Sample(lambda) * scale * table->Sample(lambda.Lambda());
        case Kind::Dense:
            return table->Sample(lambda.Lambda()) * scale;
        case Kind::PiecewiseLinear:
            return SamplePoints(lambda.Lambda());
    }
    return SampledSpectrum(0.f);
}

template <typename F>
Spectrum Spectrum::DenselySampled(F f) {
    auto table = std::make_shared<DenseTable>();
    table->values.reserve(DenseTable::Size);
    for (int i = 0; i < DenseTable::Size; ++i)
        table->values.push_back(float(f(LambdaMin + i)));
    return Dense(std::move(table));
}

}  // namespace pbrt
