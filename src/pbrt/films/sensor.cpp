#include "pbrt/films/sensor.h"

#include <fmt/format.h>

#include <span>

#include "pbrt/films/camera_matrix.h"

namespace pbrt {
namespace {

constexpr std::string_view kObserver = "cie1931";
/// The observer, then the cameras.
std::span<const std::string_view> SensorNames() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{kObserver};
        for (const CameraCurves &camera : AllCameraCurves())
            all.push_back(camera.name);
        return all;
    }();
    return names;
}

constexpr FloatParam kIso{"iso", "", 100, 1e-6f, 1e9f, "sensor speed"};
constexpr FloatParam kMaxComponent{
    "maxcomponentvalue",
    "",
    kOpen,
    0,
    kOpen,
    "samples of which the sensor's XYZ or RGB exceed it are scaled to it"};
constexpr FloatParam kWhiteBalance{
    "whitebalance",
    "K",
    0,
    0,
    25000,
    "temperature that becomes white, from 500; 0: cameras take 6500"};
constexpr float kLeastKelvin = 500, kLeastDaylight = 4000, kDefaultOfCameras = 6500;
constexpr FloatParam kDiagonal{"diagonal", "mm", 35,
                               1e-6f,      1e6f, "no effect: concerns realistic cameras only"};

/// Light of a color temperature: daylight as far as the CIE defines it, below a black body.
Spectrum LightOf(float kelvin) {
    return kelvin < kLeastDaylight ? Spectrum::Blackbody(kelvin) : Spectrum::Daylight(kelvin);
}

std::array<float, 2> ChromaticityOf(float kelvin) {
    if (kelvin >= kLeastDaylight) {
        const std::array<double, 2> xy = DaylightChromaticity(kelvin);
        return {float(xy[0]), float(xy[1])};
    }
    const XYZ c = SpectrumToXYZ(LightOf(kelvin));
    const float sum = c.X + c.Y + c.Z;
    return {c.X / sum, c.Y / sum};
}

/// The curves of a sensor, and the matrix to XYZ.
struct SensorResponse {
    std::array<Spectrum, 3> curves;
    Matrix3 xyzFromSensor;
};

SensorResponse ResponseOf(std::string_view sensor, float kelvin, const RGBColorSpace &space) {
    for (const CameraCurves &camera : AllCameraCurves()) {
        if (camera.name != sensor) continue;
        const Spectrum light = LightOf(kelvin > 0 ? kelvin : kDefaultOfCameras);
        return {CurvesOf(camera), ToFloat(XYZFromCamera(camera, light, space))};
    }
    Matrix3 adapt{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (kelvin > 0) adapt = WhiteBalance(ChromaticityOf(kelvin), space.Chromaticities()[3]);
    return {{spectra::X(), spectra::Y(), spectra::Z()}, adapt};
}

}  // namespace

Sensor Sensor::Create(ParamDict &params, const RGBColorSpace &space) {
    const ChoiceParam sensorRow{"sensor", kObserver, SensorNames(), "what colors are seen by"};
    Sensor sensor;
    sensor.iso = params.GetOneFloat(kIso);
    sensor.maxComponentValue = params.GetOneFloat(kMaxComponent);
    sensor.isLimited = sensor.maxComponentValue < Infinity;
    params.GetOneFloat(kDiagonal);
    const std::string_view name = SensorNames()[size_t(params.GetOneChoice(sensorRow))];
    float kelvin = params.GetOneFloat(kWhiteBalance);
    if (kelvin != 0 && kelvin < kLeastKelvin) {
        params.Error(kWhiteBalance.name,
                     fmt::format("\"whitebalance\" must be 0 or from {} to {} K", kLeastKelvin,
                                 kWhiteBalance.hi));
        kelvin = 0;
    }
    const auto [curves, xyzFromSensor] = ResponseOf(name, kelvin, space);
    sensor.SetResponse(curves, xyzFromSensor, space);
    const Spectrum &illuminant = space.Illuminant();
    sensor.white = illuminant.Scaled(1 / SpectrumToPhotometric(illuminant));
    return sensor;
}

/// Not over the integral of y: lights are (PBRT_FORMAT 2.10), so that a light of 1 gives a pixel of
/// 1.
void Sensor::SetResponse(const std::array<Spectrum, 3> &curves, const Matrix3 &xyzFromSensor,
                         const RGBColorSpace &space) {
    constexpr float scale = 1.f / NSpectrumSamples;
    matching.resize(size_t(LambdaMax - LambdaMin) + 1);
    for (size_t i = 0; i < matching.size(); ++i) {
        const float lambda = LambdaMin + float(i);
        std::array<float, 3> seen{curves[0](lambda), curves[1](lambda), curves[2](lambda)};
        if (!isLimited) seen = Mul(space.RGBFromXYZ(), Mul(xyzFromSensor, seen));
        matching[i] = {seen[0] * scale, seen[1] * scale, seen[2] * scale, 0};
    }
    rgbFromSensor = Product(space.RGBFromXYZ(), xyzFromSensor);
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
    if (!isLimited) return {sum[0], sum[1], sum[2]};
    const float largest = std::max(sum[0], std::max(sum[1], sum[2]));
    if (largest > maxComponentValue) sum *= maxComponentValue / largest;
    return ToFilm(sum);
}

SampledSpectrum Sensor::Exposed(SampledSpectrum L) const {
    SampledSpectrum exposed = L * (imagingRatio * CIE_Y_integral);
    const float largest = exposed.MaxComponentValue();
    if (largest > maxComponentValue) exposed *= maxComponentValue / largest;
    return exposed;
}

RGB Sensor::ColorOf(SampledSpectrum reflectance, const SampledWavelengths &lambda) const {
    const FloatX4 c = Matched(reflectance * white.Sample(lambda), lambda);
    return isLimited ? ToFilm(c) : RGB{c[0], c[1], c[2]};
}

RGB Sensor::ToFilm(FloatX4 seen) const {
    const std::array<float, 3> rgb = Mul(rgbFromSensor, {seen[0], seen[1], seen[2]});
    return {rgb[0], rgb[1], rgb[2]};
}

}  // namespace pbrt
