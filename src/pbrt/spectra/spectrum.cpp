#include "pbrt/spectra/spectrum.h"

#include <algorithm>
#include <cmath>

#include "pbrt/spectra/tables.h"

namespace pbrt {

float RGBSigmoid::MaxValue() const {
    float max = std::max((*this)(LambdaMin), (*this)(LambdaMax));
    if (c0 < 0) max = std::max(max, (*this)(std::clamp(-c1 / (2 * c0), LambdaMin, LambdaMax)));
    return max;
}

Spectrum::Spectrum(RGBSigmoid sigmoid, float scale, std::shared_ptr<const DenseTable> illuminant)
    : kind(Kind::SigmoidTimesTable), scale(scale), sigmoid(sigmoid), table(std::move(illuminant)) {
    DCHECK(table && table->values.size() == DenseTable::Size);
}

Spectrum Spectrum::Dense(std::shared_ptr<const DenseTable> table, float scale) {
    DCHECK(table && table->values.size() == DenseTable::Size);
    Spectrum s(scale);
    s.kind = Kind::Dense;
    s.table = std::move(table);
    return s;
}

Spectrum Spectrum::PiecewiseLinear(std::span<const float> lambda, std::span<const float> values) {
    DCHECK(!lambda.empty() && lambda.size() == values.size());
    DCHECK(std::adjacent_find(lambda.begin(), lambda.end(), std::greater_equal<float>()) ==
           lambda.end());
    Spectrum s(1.f);
    s.kind = Kind::PiecewiseLinear;
    s.points = std::make_shared<const Points>(
        Points{{lambda.begin(), lambda.end()}, {values.begin(), values.end()}});
    return s;
}

double BlackbodyRadiance(double lambda, double kelvin) {
    // SI 2019: exact h, c, k.
    constexpr double c = 299792458, h = 6.62607015e-34, kb = 1.380649e-23;
    const double l = lambda * 1e-9;
    return 2 * h * c * c / (l * l * l * l * l * std::expm1(h * c / (l * kb * kelvin)));
}

Spectrum Spectrum::Blackbody(float kelvin) {
    DCHECK(kelvin > 0);
    const double peak = BlackbodyRadiance(2897771.955 / kelvin, kelvin);  // Wien's law, nm
    return DenselySampled([&](float l) { return BlackbodyRadiance(l, kelvin) / peak; });
}

std::array<double, 2> DaylightChromaticity(double kelvin) {
    DCHECK(kelvin >= 4000 && kelvin <= 25000);
    const double r = 1000 / kelvin;
    const double x = kelvin <= 7000 ? 0.244063 + r * (0.09911 + r * (2.9678 - r * 4.6070))
                                    : 0.237040 + r * (0.24748 + r * (1.9018 - r * 2.0064));
    return {x, (-3 * x + 2.870) * x - 0.275};
}

Spectrum Spectrum::Daylight(double kelvin) {
    const auto [x, y] = DaylightChromaticity(kelvin);
    // Rounded to three places, as the CIE does: that makes D50 and D65 the tabulated ones.
    const auto round = [](double v) { return std::round(v * 1000) / 1000; };
    const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
    const double m1 = round((-1.3515 - 1.7703 * x + 5.9114 * y) / m);
    const double m2 = round((0.0300 - 31.4424 * x + 30.0717 * y) / m);
    namespace t = spectra::tables;
    return DenselySampled([&](float lambda) {
        const double p = (lambda - 300) / 10;
        const size_t i = std::min<size_t>(size_t(p), t::daylight0.size() - 2);
        const auto at = [&](size_t j) {
            return t::daylight0[j] + m1 * t::daylight1[j] + m2 * t::daylight2[j];
        };
        return Lerp(p - double(i), at(i), at(i + 1));
    });
}

float Spectrum::Points::operator()(float at) const {
    if (!(at >= lambda.front() && at <= lambda.back())) return 0;
    const size_t above =
        size_t(std::upper_bound(lambda.begin(), lambda.end(), at) - lambda.begin());
    if (above == lambda.size()) return values.back();
    const float t = (at - lambda[above - 1]) / (lambda[above] - lambda[above - 1]);
    return Lerp(t, values[above - 1], values[above]);
}

SampledSpectrum Spectrum::SamplePoints(SampledSpectrum lambda) const {
    SampledSpectrum s;
    for (int i = 0; i < NSpectrumSamples; ++i)
        s.Set(i, scale * (*points)(lambda[i]));
    return s;
}

float Spectrum::operator()(float lambda) const {
    switch (kind) {
        case Kind::Constant:
            return scale;
        case Kind::Sigmoid:
            return sigmoid(lambda) * scale;
        case Kind::SigmoidTimesTable:
            return sigmoid(lambda) * scale * (*table)(lambda);
        case Kind::Dense:
            return (*table)(lambda)*scale;
        case Kind::PiecewiseLinear:
            return scale * (*points)(lambda);
    }
    return 0;
}

float Spectrum::MaxValue() const {
    switch (kind) {
        case Kind::Constant:
            return scale;
        case Kind::Sigmoid:
            return sigmoid.MaxValue() * scale;
        default:
            break;
    }
    float max = 0;
    for (int i = 0; i < DenseTable::Size; ++i)
        max = std::max(max, (*this)(LambdaMin + i));
    if (points)
        for (const float l : points->lambda)
            if (l > LambdaMin && l < LambdaMax) max = std::max(max, (*this)(l));
    return max;
}

Spectrum Spectrum::Scaled(float s) const {
    Spectrum r = *this;
    r.scale *= s;
    return r;
}

Spectrum Spectrum::Densely() const {
    if (kind == Kind::Dense) return *this;
    return DenselySampled(*this);
}

namespace {

/// Sum of s times a matching function, both at whole nm.
float Integral(const Spectrum &s, const std::array<float, 471> &weight) {
    double sum = 0;
    for (int i = 0; i < DenseTable::Size; ++i)
        sum += double(s(LambdaMin + i)) * weight[i];
    return float(sum);
}

Spectrum TableSpectrum(const std::array<float, 471> &values) {
    return Spectrum::Dense(
        std::make_shared<DenseTable>(DenseTable{{values.begin(), values.end()}}));
}

}  // namespace

float SpectrumToPhotometric(const Spectrum &s) {
    return Integral(s, spectra::tables::cieY);
}

XYZ SpectrumToXYZ(const Spectrum &s) {
    namespace t = spectra::tables;
    return {Integral(s, t::cieX) / CIE_Y_integral, Integral(s, t::cieY) / CIE_Y_integral,
            Integral(s, t::cieZ) / CIE_Y_integral};
}

namespace spectra {

const Spectrum &X() {
    static const Spectrum s = TableSpectrum(tables::cieX);
    return s;
}
const Spectrum &Y() {
    static const Spectrum s = TableSpectrum(tables::cieY);
    return s;
}
const Spectrum &Z() {
    static const Spectrum s = TableSpectrum(tables::cieZ);
    return s;
}

}  // namespace spectra
}  // namespace pbrt
