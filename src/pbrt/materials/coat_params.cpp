#include "pbrt/materials/coat_params.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

constexpr FloatParam kThickness{"thickness", "",   0.01f,
                                0,           1e3f, "optical depth of the coat at normal incidence"};
constexpr FloatParam kG{
    "g", "", 0, -1, 1, "asymmetry of scattering in the coat: no effect, nothing scatters there"};
constexpr SpectrumParam kAlbedo{
    "albedo", SpectrumType::Albedo, "0", "share of light scattered in the coat: must be 0", 0, 0};
constexpr IntParam kMaxDepth{"maxdepth", 10, 0, 1 << 20,
                             "no effect: all orders of reflection are summed"};
constexpr IntParam kNSamples{"nsamples", 1, 1, 1 << 20, "no effect: nothing is left to chance"};

/// But for the rounding of interpolation.
bool IsFlat(const Spectrum &s) {
    for (int lambda = int(LambdaMin); lambda <= int(LambdaMax); ++lambda)
        if (std::abs(s(float(lambda)) - s(LambdaMin)) > 1e-5f * s(LambdaMin)) return false;
    return true;
}

float GetEta(ParamDict &params, const CoatEtaRows &rows) {
    const FloatParam &row = rows.number;
    if (params.Has(row)) return params.GetOneFloat(row);
    const std::optional<Spectrum> eta = params.GetOneSpectrum(rows.spectrum);
    if (!eta) return row.def;
    const float value = (*eta)(LambdaMin);
    if (!IsFlat(*eta))
        params.Error(row.name, fmt::format("a coat whose \"{}\" varies with wavelength is not "
                                           "supported",
                                           row.name));
    else if (value >= row.lo && value <= row.hi)
        return value;
    else
        params.Error(row.name, fmt::format("\"{}\" is {}, outside [{}, {}]", row.name, value,
                                           row.lo, row.hi));
    return row.def;
}

}  // namespace

CoatParams CoatParams::Get(ParamDict &params, const NamedTextures &named, const CoatEtaRows &rows) {
    const CoatParams coat{GetEta(params, rows), params.GetOneFloat(kThickness)};
    GetFloatTexture(params, named, kG);
    const SpectrumTexture albedo = GetSpectrumTexture(params, named, kAlbedo);
    if (!albedo.IsConstant() || albedo.Constant().MaxValue() > 0)
        params.Error(
            kAlbedo.name,
            "a coat that scatters is not supported: \"albedo\" must be 0. Leave it out and give "
            "the "
            "base the color that both show, or \"mix\" it with \"diffuse\" of the coat's color");
    params.GetOneInt(kMaxDepth);
    params.GetOneInt(kNSamples);
    return coat;
}

Coat CoatParams::CoatWith(const Roughness &roughness) const {
    if (!roughness.u.IsConstant() || !roughness.v.IsConstant())
        return Coat::ForTextures(eta, depth);
    const Vector2f alpha = roughness.Alpha({});
    return Coat(eta, depth, alpha.x, alpha.y);
}

}  // namespace pbrt
