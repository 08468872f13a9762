#include "pbrt/materials/coated_diffuse.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "0.5",
                                     "albedo of the base"};
constexpr FloatParam kEta{"eta", "", 1.5f, 1, 1e3f, "index of refraction of the coat"};
constexpr SpectrumParam kEtaSpectrum{
    "eta", SpectrumType::Unbounded, "", "the same, which must not vary with wavelength", 1, 1e3f};
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

float ReadEta(ParamDict &params) {
    if (params.Has(kEta)) return params.GetOneFloat(kEta);
    const std::optional<Spectrum> eta = params.GetOneSpectrum(kEtaSpectrum);
    if (!eta) return kEta.def;
    const float value = (*eta)(LambdaMin);
    if (!IsFlat(*eta))
        params.Error(kEta.name, "a coat whose \"eta\" varies with wavelength is not supported");
    else if (value >= kEta.lo && value <= kEta.hi)
        return value;
    else
        params.Error(kEta.name,
                     fmt::format("\"eta\" is {}, outside [{}, {}]", value, kEta.lo, kEta.hi));
    return kEta.def;
}

Coat CoatWith(float eta, float depth, const Roughness &roughness) {
    if (!roughness.u.IsConstant() || !roughness.v.IsConstant())
        return Coat::ForTextures(eta, depth);
    const Vector2f alpha = roughness.Alpha({});
    return Coat(eta, depth, alpha.x, alpha.y);
}

}  // namespace

CoatedDiffuseMaterial CoatedDiffuseMaterial::Create(ParamDict &params, const NamedTextures &named) {
    CoatedDiffuseMaterial m;
    m.reflectance = GetSpectrumTexture(params, named, kReflectance);
    m.roughness = Roughness::Create(params, named);
    const float eta = ReadEta(params), depth = params.GetOneFloat(kThickness);
    GetFloatTexture(params, named, kG);
    const SpectrumTexture albedo = GetSpectrumTexture(params, named, kAlbedo);
    if (!albedo.IsConstant() || albedo.Constant().MaxValue() > 0)
        params.Error(kAlbedo.name, "a coat that scatters is not supported: \"albedo\" must be 0");
    params.GetOneInt(kMaxDepth);
    params.GetOneInt(kNSamples);
    m.coat = std::make_shared<const Coat>(CoatWith(eta, depth, m.roughness));
    return m;
}

}  // namespace pbrt
