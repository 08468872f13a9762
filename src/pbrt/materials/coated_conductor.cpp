#include "pbrt/materials/coated_conductor.h"

#include "pbrt/materials/coat_params.h"

namespace pbrt {
namespace {

constexpr SpectrumParam kEta{"conductor.eta", SpectrumType::Unbounded, "metal-Cu-eta",
                             "index of refraction of the metal"};
constexpr SpectrumParam kK{"conductor.k", SpectrumType::Unbounded, "metal-Cu-k",
                           "absorption coefficient of the metal"};
constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "",
                                     "of the metal, instead of conductor.eta and conductor.k"};
constexpr CoatEtaRows kCoatEta{
    {"interface.eta", "", 1.5f, 1, 1e3f, "index of refraction of the coat"},
    {"interface.eta", SpectrumType::Unbounded, "", "the same, which must not vary with wavelength",
     1, 1e3f}};
constexpr RoughnessRows kCoatRoughness{
    {"interface.roughness", "", 0, 0, 1e6f, "microfacet roughness of the coat; 0: smooth"},
    {"interface.uroughness", "", 0, 0, 1e6f, "along dp/du; not given: interface.roughness"},
    {"interface.vroughness", "", 0, 0, 1e6f, "along dp/dv; not given: interface.roughness"}};
constexpr RoughnessRows kBaseRoughness{
    {"conductor.roughness", "", 0, 0, 1e6f, "microfacet roughness of the metal; 0: smooth"},
    {"conductor.uroughness", "", 0, 0, 1e6f, "along dp/du; not given: conductor.roughness"},
    {"conductor.vroughness", "", 0, 0, 1e6f, "along dp/dv; not given: conductor.roughness"}};

CoatedConductorBxDF::Alphas AlphasOf(const Roughness &r, const TextureEvalContext &ctx) {
    const Vector2f alpha = r.Alpha(ctx);
    return {std::min(alpha.x, Coat::kRoughest), std::min(alpha.y, Coat::kRoughest)};
}

/// A coat of index 1 has no boundary, so no facets either.
CoatedConductorBxDF::Alphas CoatAlphas(const Roughness &r, const Coat &coat,
                                       const TextureEvalContext &ctx) {
    if (coat.Eta() == 1) return {0, 0};
    return AlphasOf(r, ctx);
}

bool IsConstant(const Roughness &r) {
    return r.u.IsConstant() && r.v.IsConstant();
}

CoatedBase BaseUnder(const Coat &coat, const Roughness &coatRoughness,
                     const Roughness &baseRoughness) {
    if (!IsConstant(coatRoughness) || !IsConstant(baseRoughness))
        return CoatedBase(coat, 0, Coat::kSmooth, Coat::kRoughest);
    const auto alphas = CoatedConductorBxDF::WidenedBy(CoatAlphas(coatRoughness, coat, {}),
                                                       coat.Eta(), AlphasOf(baseRoughness, {}));
    const float mean = std::sqrt((Sqr(alphas.x) + Sqr(alphas.y)) / 2);
    const float alpha = std::max(mean, Coat::kSmooth);
    const auto onCoat = CoatAlphas(coatRoughness, coat, {});
    const float coatAlpha = std::sqrt((Sqr(onCoat.x) + Sqr(onCoat.y)) / 2);
    return CoatedBase(coat, coatAlpha, alpha, alpha);
}

}  // namespace

CoatedConductorMaterial CoatedConductorMaterial::Create(ParamDict &params,
                                                        const NamedTextures &named) {
    CoatedConductorMaterial m;
    const auto eta = FindSpectrumTexture(params, named, kEta);
    const auto k = FindSpectrumTexture(params, named, kK);
    m.reflectance = FindSpectrumTexture(params, named, kReflectance);
    if (m.reflectance && (eta || k))
        params.Error(kReflectance.name,
                     "give \"reflectance\" or \"conductor.eta\" and \"conductor.k\", not both");
    m.eta = eta.value_or(DefaultSpectrum(kEta));
    m.k = k.value_or(DefaultSpectrum(kK));
    m.coatRoughness = Roughness::Create(params, named, kCoatRoughness);
    m.baseRoughness = Roughness::Create(params, named, kBaseRoughness);
    const CoatParams coat = CoatParams::Get(params, named, kCoatEta);
    m.coat = std::make_shared<const Coat>(coat.CoatWith(m.coatRoughness));
    m.base =
        std::make_shared<const CoatedBase>(BaseUnder(*m.coat, m.coatRoughness, m.baseRoughness));
    return m;
}

CoatedConductorBxDF CoatedConductorMaterial::GetBxDF(const TextureEvalContext &ctx,
                                                     const SampledWavelengths &lambda) const {
    const auto [n, absorption] =
        reflectance ? IndexOf(reflectance->Evaluate(ctx, lambda))
                    : ComplexIndex{eta.Evaluate(ctx, lambda), k.Evaluate(ctx, lambda)};
    const float inCoat = 1 / coat->Eta();
    return CoatedConductorBxDF(n * inCoat, absorption * inCoat, *coat, *base,
                               CoatAlphas(coatRoughness, *coat, ctx), AlphasOf(baseRoughness, ctx));
}

std::string CoatedConductorMaterial::Warnings(const ClampCounts &counts) const {
    std::string onCoat = coatRoughness.Warnings(kName, counts);
    const std::string onBase = baseRoughness.Warnings(kName, counts);
    if (onCoat.empty() || onBase.empty() || onCoat == onBase)
        return onCoat.empty() ? onBase : onCoat;
    return onCoat + "; " + onBase;
}

}  // namespace pbrt
