#include "pbrt/textures/checkerboard.h"

namespace pbrt {
namespace {

/// 0 in even cells, 1 in odd ones; without the limits of int.
float Parity(float sumOfCells) {
    return sumOfCells - 2 * std::floor(sumOfCells / 2);
}

/// Mean over [x - half, x + half] of the wave that is 1 in even cells and -1 in odd ones.
float MeanWave(float x, float half) {
    if (std::floor(x - half) == std::floor(x + half)) return 1 - 2 * Parity(std::floor(x));
    // The wave's integral from 0 is a triangle wave of period 2 and height 1.
    const auto triangle = [](float y) { return 1 - std::abs(Parity(y) - 1); };
    return (triangle(x + half) - triangle(x - half)) / (2 * half);
}

struct CheckerFloat : FloatNode {
    CheckerFloat(Checkerboard board, FloatTexture tex1, FloatTexture tex2)
        : board(std::move(board)), tex1(std::move(tex1)), tex2(std::move(tex2)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        const float t = board.Second(ctx);
        if (t == 0) return tex1.Evaluate(ctx);
        if (t == 1) return tex2.Evaluate(ctx);
        return Lerp(t, tex1.Evaluate(ctx), tex2.Evaluate(ctx));
    }
    Checkerboard board;
    FloatTexture tex1, tex2;
};

struct CheckerSpectrum : SpectrumNode {
    CheckerSpectrum(Checkerboard board, SpectrumTexture tex1, SpectrumTexture tex2)
        : board(std::move(board)), tex1(std::move(tex1)), tex2(std::move(tex2)) {}
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const override {
        const float t = board.Second(ctx);
        if (t == 0) return tex1.Evaluate(ctx, lambda);
        if (t == 1) return tex2.Evaluate(ctx, lambda);
        return Lerp(t, tex1.Evaluate(ctx, lambda), tex2.Evaluate(ctx, lambda));
    }
    Checkerboard board;
    SpectrumTexture tex1, tex2;
};

}  // namespace

Checkerboard Checkerboard::Create(TextureBuilder &builder) {
    if (builder.params.GetOneInt("dimension", 2, 2, 3) == 3)
        return Checkerboard(builder.textureFromRender);
    return Checkerboard(TextureMapping2D::Create(builder.params, builder.textureFromRender));
}

float Checkerboard::Second(const TextureEvalContext &ctx) const {
    if (const Transform *textureFromRender = std::get_if<Transform>(&space)) {
        const Point3f p = textureFromRender->Point(ctx.p);
        return Parity(std::floor(p.x) + std::floor(p.y) + std::floor(p.z));
    }
    const TexCoord2D c = std::get<TextureMapping2D>(space).Map(ctx);
    const float halfS = (std::abs(c.dsdx) + std::abs(c.dsdy)) / 2;
    const float halfT = (std::abs(c.dtdx) + std::abs(c.dtdy)) / 2;
    return 0.5f - 0.5f * MeanWave(c.st.x, halfS) * MeanWave(c.st.y, halfT);
}

FloatTexture CheckerboardTexture::CreateFloat(TextureBuilder &builder) {
    Checkerboard board = Checkerboard::Create(builder);
    FloatTexture tex1 = builder.Float("tex1", 1), tex2 = builder.Float("tex2", 0);
    return FloatTexture(std::make_shared<CheckerFloat>(std::move(board), tex1, tex2));
}

SpectrumByRole CheckerboardTexture::CreateSpectrum(TextureBuilder &builder) {
    const Checkerboard board = Checkerboard::Create(builder);
    const SpectrumByRole tex1 = builder.Spectra("tex1", 1), tex2 = builder.Spectra("tex2", 0);
    return ForEachRole(tex1, tex2, [&](const SpectrumTexture &a, const SpectrumTexture &b) {
        return SpectrumTexture(std::make_shared<CheckerSpectrum>(board, a, b));
    });
}

}  // namespace pbrt
