#include "pbrt/textures/mix.h"

namespace pbrt {
namespace {

struct MixedFloat : FloatNode {
    MixedFloat(FloatTexture tex1, FloatTexture tex2, FloatTexture amount)
        : tex1(std::move(tex1)), tex2(std::move(tex2)), amount(std::move(amount)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        const float t = amount.Evaluate(ctx);
        if (t == 0) return tex1.Evaluate(ctx);
        if (t == 1) return tex2.Evaluate(ctx);
        return Lerp(t, tex1.Evaluate(ctx), tex2.Evaluate(ctx));
    }
    FloatTexture tex1, tex2, amount;
};

struct MixedSpectrum : SpectrumNode {
    MixedSpectrum(SpectrumTexture tex1, SpectrumTexture tex2, FloatTexture amount)
        : tex1(std::move(tex1)), tex2(std::move(tex2)), amount(std::move(amount)) {}
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const override {
        const float t = amount.Evaluate(ctx);
        if (t == 0) return tex1.Evaluate(ctx, lambda);
        if (t == 1) return tex2.Evaluate(ctx, lambda);
        return Lerp(t, tex1.Evaluate(ctx, lambda), tex2.Evaluate(ctx, lambda));
    }
    SpectrumTexture tex1, tex2;
    FloatTexture amount;
};

Spectrum MixedConstants(const Spectrum &a, const Spectrum &b, float t) {
    if (a.IsConstant() && b.IsConstant()) return Spectrum(Lerp(t, a(LambdaMin), b(LambdaMin)));
    return Spectrum::DenselySampled([&](float lambda) { return Lerp(t, a(lambda), b(lambda)); });
}

}  // namespace

FloatTexture Mixed(const FloatTexture &tex1, const FloatTexture &tex2, const FloatTexture &amount) {
    if (amount.IsConstant()) {
        const float t = amount.Constant();
        if (t == 0) return tex1;
        if (t == 1) return tex2;
        if (tex1.IsConstant() && tex2.IsConstant())
            return Lerp(t, tex1.Constant(), tex2.Constant());
    }
    return FloatTexture(std::make_shared<MixedFloat>(tex1, tex2, amount));
}

SpectrumTexture Mixed(const SpectrumTexture &tex1, const SpectrumTexture &tex2,
                      const FloatTexture &amount) {
    if (amount.IsConstant()) {
        const float t = amount.Constant();
        if (t == 0) return tex1;
        if (t == 1) return tex2;
        if (tex1.IsConstant() && tex2.IsConstant())
            return MixedConstants(tex1.Constant(), tex2.Constant(), t);
    }
    return SpectrumTexture(std::make_shared<MixedSpectrum>(tex1, tex2, amount));
}

FloatTexture MixTexture::CreateFloat(TextureBuilder &builder) {
    const FloatTexture tex1 = builder.Float("tex1", 0), tex2 = builder.Float("tex2", 1);
    return Mixed(tex1, tex2, builder.Float("amount", 0.5f));
}

SpectrumByRole MixTexture::CreateSpectrum(TextureBuilder &builder) {
    const SpectrumByRole tex1 = builder.Spectra("tex1", 0), tex2 = builder.Spectra("tex2", 1);
    const FloatTexture amount = builder.Float("amount", 0.5f);
    return ForEachRole(tex1, tex2, [&](const SpectrumTexture &a, const SpectrumTexture &b) {
        return Mixed(a, b, amount);
    });
}

}  // namespace pbrt
