#include "pbrt/materials/hair.h"

#include <fmt/format.h>

#include "pbrt/bxdfs/hair_absorption.h"

namespace pbrt {
namespace {

constexpr SpectrumParam kSigmaA{"sigma_a", SpectrumType::Unbounded, "",
                                "absorption per fibre radius; outranks all other pigments"};
constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "",
                                     "color of a mass of such fibres; outranks the melanins"};
constexpr SpectrumParam kColor{"color", SpectrumType::Albedo, "", "another name of reflectance"};
constexpr FloatParam kEumelanin{
    "eumelanin", "", 1.3f, 0, 1e6f, "brown and black pigment; 0 where pheomelanin is given"};
constexpr FloatParam kPheomelanin{"pheomelanin", "", 0, 0, 1e6f, "red and yellow pigment"};
constexpr FloatParam kEta{"eta", "", 1.55f, 1, 1e3f, "index of refraction of the inside"};
constexpr FloatParam kBetaM{"beta_m", "", 0.3f, 0.01f, 1, "roughness along the fibre"};
constexpr FloatParam kBetaN{"beta_n", "", 0.3f, 0.01f, 1, "roughness around the fibre"};
constexpr FloatParam kAlpha{"alpha", "deg", 2, -90, 90, "tilt of the scales"};
}  // namespace

HairMaterial HairMaterial::Create(ParamDict &params, const NamedTextures &named) {
    HairMaterial m;
    const auto sigma_a = FindSpectrumTexture(params, named, kSigmaA);
    const auto reflectance = FindSpectrumTexture(params, named, kReflectance);
    const auto color = FindSpectrumTexture(params, named, kColor);
    if (reflectance && color)
        params.Error(kColor.name,
                     "give \"reflectance\" or \"color\", which means the same, not both");
    const auto outrank = [&](std::string_view winner, std::initializer_list<ParamRow> others) {
        for (const ParamRow &row : others)
            if (params.HasOrTexture(row))
                params.Warning(NameOf(row), fmt::format("\"{}\" has no effect beside \"{}\"",
                                                        NameOf(row), winner));
    };
    if (sigma_a) {
        m.pigment = Pigment::SigmaA, m.color = *sigma_a;
        outrank(kSigmaA.name, {kReflectance, kColor, kEumelanin, kPheomelanin});
    } else if (reflectance || color) {
        m.pigment = Pigment::Reflectance, m.color = reflectance ? *reflectance : *color;
        outrank(reflectance ? kReflectance.name : kColor.name, {kEumelanin, kPheomelanin});
    }
    FloatParam eumelanin = kEumelanin;
    if (params.HasOrTexture(kEumelanin) || params.HasOrTexture(kPheomelanin)) eumelanin.def = 0;
    m.eumelanin = {params, named, eumelanin};
    m.pheomelanin = {params, named, kPheomelanin};
    if (m.pigment == Pigment::Melanin && m.eumelanin.IsConstant() && m.pheomelanin.IsConstant()) {
        const RGB sigma = SigmaAFromConcentration(m.eumelanin.Constant(), m.pheomelanin.Constant());
        m.pigment = Pigment::SigmaA;
        m.color = RGBColorSpace::sRGB().UnboundedSpectrum(sigma);
    }
    m.eta = {params, named, kEta};
    m.betaM = {params, named, kBetaM};
    m.betaN = {params, named, kBetaN};
    m.alpha = {params, named, kAlpha};
    return m;
}

SampledSpectrum HairMaterial::Absorption(const TextureEvalContext &ctx,
                                         const SampledWavelengths &lambda, float beta_n) const {
    switch (pigment) {
        case Pigment::SigmaA:
            return ClampZero(color.Evaluate(ctx, lambda));
        case Pigment::Reflectance:
            return SigmaAFromReflectance(color.Evaluate(ctx, lambda), beta_n);
        case Pigment::Melanin:
            break;
    }
    const RGB sigma = SigmaAFromConcentration(eumelanin.Evaluate(ctx), pheomelanin.Evaluate(ctx));
    return RGBColorSpace::sRGB().SampleUnbounded(sigma, lambda);
}

std::string HairMaterial::Warnings(const ClampCounts &counts) const {
    std::string text;
    for (const BoundedTexture *t : {&eumelanin, &pheomelanin, &eta, &betaM, &betaN, &alpha})
        t->AddWarning(kName, counts, &text);
    return text;
}

}  // namespace pbrt
