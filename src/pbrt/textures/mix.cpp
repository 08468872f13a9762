#include "pbrt/textures/mix.h"

namespace pbrt {
namespace {

constexpr FloatParam kTex1{"tex1", "", 0, -kOpen, kOpen, "value where amount is 0"};
constexpr FloatParam kTex2{"tex2", "", 1, -kOpen, kOpen, "value where amount is 1"};
constexpr SpectrumParam kSpectrum1{"tex1", SpectrumType::Unbounded, "0", "value where amount is 0"};
constexpr SpectrumParam kSpectrum2{"tex2", SpectrumType::Unbounded, "1", "value where amount is 1"};
constexpr FloatParam kAmount{"amount", "", 0.5f, -kOpen, kOpen, "share of tex2"};

/// (1 - t) a + t b, asking for both only where both count.
template <typename Texture, typename... Args>
auto MixedAt(const Texture &a, const Texture &b, float t, const Args &...args) {
    if (t == 0) return a.Evaluate(args...);
    if (t == 1) return b.Evaluate(args...);
    return Lerp(t, a.Evaluate(args...), b.Evaluate(args...));
}

struct MixedFloat : FloatNode {
    MixedFloat(FloatTexture tex1, FloatTexture tex2, FloatTexture amount)
        : tex1(std::move(tex1)), tex2(std::move(tex2)), amount(std::move(amount)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        return MixedAt(tex1, tex2, amount.Evaluate(ctx), ctx);
    }
    FloatTexture tex1, tex2, amount;
};

struct MixedSpectrum : SpectrumNode {
    MixedSpectrum(SpectrumTexture tex1, SpectrumTexture tex2, FloatTexture amount)
        : tex1(std::move(tex1)), tex2(std::move(tex2)), amount(std::move(amount)) {}
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const override {
        return MixedAt(tex1, tex2, amount.Evaluate(ctx), ctx, lambda);
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

SpectrumByRole Mixed(const SpectrumByRole &tex1, const SpectrumByRole &tex2,
                     const FloatTexture &amount) {
    SpectrumByRole made;
    for (size_t i = 0; i < made.size(); ++i)
        if (tex1[i] && tex2[i]) made[i] = Mixed(*tex1[i], *tex2[i], amount);
    return made;
}

FloatTexture MixTexture::CreateFloat(TextureBuilder &builder) {
    const FloatTexture tex1 = builder.Float(kTex1), tex2 = builder.Float(kTex2);
    return Mixed(tex1, tex2, builder.Float(kAmount));
}

SpectrumByRole MixTexture::CreateSpectrum(TextureBuilder &builder) {
    const SpectrumByRole tex1 = builder.Spectra(kSpectrum1), tex2 = builder.Spectra(kSpectrum2);
    return Mixed(tex1, tex2, builder.Float(kAmount));
}

}  // namespace pbrt
