#include "pbrt/materials/coated_diffuse.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

constexpr FloatParam kEta{"eta", "", 1.5f, 1, 1e3f, "index of refraction of the coat"};
constexpr FloatParam kThickness{"thickness", "", 0.01f, 0, 1e3f, "optical depth of the coat"};
constexpr FloatParam kG{"g", "", 0, -1, 1, "asymmetry of scattering in the coat"};

/// But for the rounding of interpolation.
bool IsFlat(const Spectrum &s) {
    for (int lambda = int(LambdaMin); lambda <= int(LambdaMax); ++lambda)
        if (std::abs(s(float(lambda)) - s(LambdaMin)) > 1e-5f * s(LambdaMin)) return false;
    return true;
}

float ReadEta(ParamDict &params) {
    if (params.Has("eta", "float")) return params.GetOneFloat(kEta);
    const std::optional<Spectrum> eta = params.GetOneSpectrum("eta", SpectrumType::Unbounded);
    if (!eta) return kEta.def;
    const float value = (*eta)(LambdaMin);
    if (!IsFlat(*eta))
        params.Error("eta", "a coat whose \"eta\" varies with wavelength is not supported");
    else if (value >= kEta.lo && value <= kEta.hi)
        return value;
    else
        params.Error("eta",
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
    m.reflectance =
        GetSpectrumTexture(params, named, "reflectance", Spectrum(0.5f), SpectrumType::Albedo);
    m.roughness = Roughness::Create(params, named);
    const float eta = ReadEta(params), depth = params.GetOneFloat(kThickness);
    GetFloatTexture(params, named, kG);
    const SpectrumTexture albedo =
        GetSpectrumTexture(params, named, "albedo", Spectrum(0.f), SpectrumType::Albedo);
    if (!albedo.IsConstant() || albedo.Constant().MaxValue() > 0)
        params.Error("albedo", "a coat that scatters is not supported: \"albedo\" must be 0");
    params.GetOneInt("maxdepth", 10, 0, 1 << 20);
    params.GetOneInt("nsamples", 1, 1, 1 << 20);
    m.coat = std::make_shared<const Coat>(CoatWith(eta, depth, m.roughness));
    return m;
}

}  // namespace pbrt
