#include "pbrt/films/sensor.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 1> kSensors{"cie1931"};
constexpr FloatParam kIso{"iso", "", 100, 1e-6f, 1e9f, "sensor speed"};
constexpr ChoiceParam kSensor{"sensor", kSensors[0], kSensors, "what colors are seen by"};
constexpr FloatParam kMaxComponent{
    "maxcomponentvalue", "", kOpen, 0, kOpen, "larger samples are scaled down to it"};
constexpr FloatParam kWhiteBalance{
    "whitebalance", "K", 0, 0, 25000, "color temperature that becomes white, from 4000; 0: none"};
constexpr FloatParam kDiagonal{"diagonal", "mm", 35,
                               1e-6f,      1e6f, "no effect: concerns realistic cameras only"};

/// Matching curves in the film's RGB over the number of wavelength samples. Not over the integral
/// of y: lights are (PBRT_FORMAT 2.10), so that a light of 1 gives a pixel of 1.
std::vector<std::array<float, 4>> Matching(const RGBColorSpace &space, float whiteBalance) {
    Matrix3 adapt{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (whiteBalance > 0) {
        const std::array<double, 2> xy = DaylightChromaticity(whiteBalance);
        adapt = WhiteBalance({float(xy[0]), float(xy[1])}, space.Chromaticities()[3]);
    }
    std::vector<std::array<float, 4>> table(int(LambdaMax - LambdaMin) + 1);
    constexpr float scale = 1.f / NSpectrumSamples;
    for (size_t i = 0; i < table.size(); ++i) {
        const float lambda = LambdaMin + float(i);
        const std::array<float, 3> xyz =
            Mul(adapt, {spectra::X()(lambda), spectra::Y()(lambda), spectra::Z()(lambda)});
        const std::array<float, 3> rgb = Mul(space.RGBFromXYZ(), xyz);
        table[i] = {rgb[0] * scale, rgb[1] * scale, rgb[2] * scale, 0};
    }
    return table;
}

}  // namespace

Sensor Sensor::Create(ParamDict &params, const RGBColorSpace &space) {
    Sensor sensor;
    sensor.iso = params.GetOneFloat(kIso);
    sensor.maxComponentValue = params.GetOneFloat(kMaxComponent);
    params.GetOneFloat(kDiagonal);
    params.GetOneChoice(kSensor);
    const float kelvin = params.GetOneFloat(kWhiteBalance);
    if (kelvin != 0 && kelvin < 4000)
        params.Error(kWhiteBalance.name, "\"whitebalance\" must be 0 or from 4000 to 25000 K");
    sensor.matching = Matching(space, kelvin);
    const Spectrum &illuminant = space.Illuminant();
    sensor.white = illuminant.Scaled(1 / SpectrumToPhotometric(illuminant));
    return sensor;
}

FloatX4 Sensor::Matched(SampledSpectrum L, const SampledWavelengths &lambda) const {
    const SampledSpectrum pdf = lambda.PDF();
    FloatX4 sum{};
    for (int i = 0; i < NSpectrumSamples; ++i) {
        if (pdf[i] == 0) continue;
        const float at = lambda[i] - LambdaMin;
        const int k = std::min(int(at), int(LambdaMax - LambdaMin) - 1);
        const float t = at - float(k);
        const float *a = matching[size_t(k)].data(), *b = matching[size_t(k) + 1].data();
        const FloatX4 va{a[0], a[1], a[2], a[3]}, vb{b[0], b[1], b[2], b[3]};
        sum += (va + (vb - va) * t) * (L[i] / pdf[i]);
    }
    return sum;
}

RGB Sensor::Response(SampledSpectrum L, const SampledWavelengths &lambda) const {
    FloatX4 sum = Matched(L, lambda) * imagingRatio;
    const float largest = std::max(sum[0], std::max(sum[1], sum[2]));
    if (largest > maxComponentValue) sum *= maxComponentValue / largest;
    return {sum[0], sum[1], sum[2]};
}

SampledSpectrum Sensor::Exposed(SampledSpectrum L) const {
    SampledSpectrum exposed = L * (imagingRatio * CIE_Y_integral);
    const float largest = exposed.MaxComponentValue();
    if (largest > maxComponentValue) exposed *= maxComponentValue / largest;
    return exposed;
}

RGB Sensor::ColorOf(SampledSpectrum reflectance, const SampledWavelengths &lambda) const {
    const FloatX4 c = Matched(reflectance * white.Sample(lambda), lambda);
    return {c[0], c[1], c[2]};
}

}  // namespace pbrt
