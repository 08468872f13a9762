#include "pbrt/materials/hair.h"

#include <fmt/format.h>

#include "pbrt/bxdfs/hair_absorption.h"

namespace pbrt {
namespace {

constexpr FloatParam kEumelanin{"eumelanin", "", 0, 0, 1e6f, "brown and black pigment"};
constexpr FloatParam kPheomelanin{"pheomelanin", "", 0, 0, 1e6f, "red and yellow pigment"};
constexpr FloatParam kEta{"eta", "", 1.55f, 1, 1e3f, "index of refraction of the inside"};
constexpr FloatParam kBetaM{"beta_m", "", 0.3f, 0.01f, 1, "roughness along the fibre"};
constexpr FloatParam kBetaN{"beta_n", "", 0.3f, 0.01f, 1, "roughness around the fibre"};
constexpr FloatParam kAlpha{"alpha", "degrees", 2, -90, 90, "tilt of the scales"};

/// Where no pigment is named at all.
constexpr float kDefaultEumelanin = 1.3f;

}  // namespace

HairMaterial HairMaterial::Create(ParamDict &params, const NamedTextures &named) {
    HairMaterial m;
    const auto sigma_a = FindSpectrumTexture(params, named, "sigma_a", SpectrumType::Unbounded);
    const auto reflectance =
        FindSpectrumTexture(params, named, "reflectance", SpectrumType::Albedo);
    const auto color = FindSpectrumTexture(params, named, "color", SpectrumType::Albedo);
    if (reflectance && color)
        params.Error("color", "give \"reflectance\" or \"color\", which means the same, not both");
    const auto given = [&](std::string_view name) {
        return params.Has(name, "float") || params.Has(name, "texture");
    };
    const auto outrank = [&](std::string_view winner,
                             std::initializer_list<std::string_view> names) {
        for (std::string_view name : names)
            if (params.Has(name))
                params.Warning(name,
                               fmt::format("\"{}\" has no effect beside \"{}\"", name, winner));
    };
    if (sigma_a) {
        m.pigment = Pigment::SigmaA, m.color = *sigma_a;
        outrank("sigma_a", {"reflectance", "color", "eumelanin", "pheomelanin"});
    } else if (reflectance || color) {
        m.pigment = Pigment::Reflectance, m.color = reflectance ? *reflectance : *color;
        outrank(reflectance ? "reflectance" : "color", {"eumelanin", "pheomelanin"});
    }
    FloatParam eumelanin = kEumelanin;
    if (!given("eumelanin") && !given("pheomelanin")) eumelanin.def = kDefaultEumelanin;
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

std::string HairMaterial::Warnings() const {
    std::string text;
    for (const BoundedTexture *t : {&eumelanin, &pheomelanin, &eta, &betaM, &betaN, &alpha})
        t->AddRemark(kName, &text);
    return text;
}

}  // namespace pbrt
