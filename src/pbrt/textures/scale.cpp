#include "pbrt/textures/scale.h"

namespace pbrt {
namespace {

constexpr FloatParam kTex{"tex", "", 1, -kOpen, kOpen, "what is multiplied"};
constexpr SpectrumParam kSpectrum{"tex", SpectrumType::Unbounded, "1", "what is multiplied"};
constexpr FloatParam kScale{"scale", "", 1, -kOpen, kOpen, "factor"};
// Spectra do not go below 0, so neither may what scales them.
constexpr FloatParam kSpectrumScale{"scale", "", 1, 0, kOpen, "factor"};

struct ScaledFloat : FloatNode {
    ScaledFloat(FloatTexture texture, FloatTexture scale)
        : texture(std::move(texture)), scale(std::move(scale)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        const float s = scale.Evaluate(ctx);
        return s == 0 ? 0 : s * texture.Evaluate(ctx);
    }
    FloatTexture texture, scale;
};

struct ScaledSpectrum : SpectrumNode {
    ScaledSpectrum(SpectrumTexture texture, FloatTexture scale)
        : texture(std::move(texture)), scale(std::move(scale)) {}
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const override {
        const float s = scale.Evaluate(ctx);
        return s == 0 ? SampledSpectrum(0.f) : s * texture.Evaluate(ctx, lambda);
    }
    SpectrumTexture texture;
    FloatTexture scale;
};

}  // namespace

FloatTexture Scaled(const FloatTexture &texture, const FloatTexture &scale) {
    if (texture.IsConstant() && scale.IsConstant()) return texture.Constant() * scale.Constant();
    if (scale.IsConstant() && scale.Constant() == 1) return texture;
    if (texture.IsConstant() && texture.Constant() == 1) return scale;
    return FloatTexture(std::make_shared<ScaledFloat>(texture, scale));
}

SpectrumTexture Scaled(const SpectrumTexture &texture, const FloatTexture &scale) {
    if (texture.IsConstant() && scale.IsConstant())
        return texture.Constant().Scaled(scale.Constant());
    if (scale.IsConstant() && scale.Constant() == 1) return texture;
    return SpectrumTexture(std::make_shared<ScaledSpectrum>(texture, scale));
}

FloatTexture ScaleTexture::CreateFloat(TextureBuilder &builder) {
    const FloatTexture texture = builder.Float(kTex);
    return Scaled(texture, builder.Float(kScale));
}

SpectrumByRole ScaleTexture::CreateSpectrum(TextureBuilder &builder) {
    SpectrumByRole texture = builder.Spectra(kSpectrum);
    const FloatTexture scale = builder.Float(kSpectrumScale);
    for (std::optional<SpectrumTexture> &t : texture)
        if (t) t = Scaled(*t, scale);
    return texture;
}

}  // namespace pbrt
