#include "pbrt/textures/checkerboard.h"

#include "pbrt/textures/mapping2d.h"
#include "pbrt/textures/mix.h"

namespace pbrt {
namespace {

constexpr IntParam kDimension{"dimension", 2, 2, 3,
                              "2: squares of the mapping's coordinates; 3: cubes of texture space"};
constexpr FloatParam kTex1{"tex1", "", 1, -kOpen, kOpen, "value of even cells"};
constexpr FloatParam kTex2{"tex2", "", 0, -kOpen, kOpen, "value of odd cells"};
constexpr SpectrumParam kSpectrum1{"tex1", SpectrumType::Unbounded, "1", "value of even cells"};
constexpr SpectrumParam kSpectrum2{"tex2", SpectrumType::Unbounded, "0", "value of odd cells"};

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

/// Share of tex2, 0 to 1.
struct Squares : FloatNode {
    explicit Squares(TextureMapping2D mapping) : mapping(std::move(mapping)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        const TexCoord2D c = mapping.Map(ctx);
        const float halfS = (std::abs(c.dsdx) + std::abs(c.dsdy)) / 2;
        const float halfT = (std::abs(c.dtdx) + std::abs(c.dtdy)) / 2;
        return 0.5f - 0.5f * MeanWave(c.st.x, halfS) * MeanWave(c.st.y, halfT);
    }
    TextureMapping2D mapping;
};

struct Cubes : FloatNode {
    explicit Cubes(const Transform &textureFromRender) : textureFromRender(textureFromRender) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        const Point3f p = textureFromRender.Point(ctx.p);
        return Parity(std::floor(p.x) + std::floor(p.y) + std::floor(p.z));
    }
    Transform textureFromRender;
};

FloatTexture CreateBoard(TextureBuilder &builder) {
    if (builder.params.GetOneInt(kDimension) == 3)
        return FloatTexture(std::make_shared<Cubes>(builder.textureFromRender));
    builder.named.readFootprints = true;
    const auto mapping = TextureMapping2D::Create(builder.params, builder.textureFromRender);
    builder.readsUV |= mapping.ReadsUV();
    return FloatTexture(std::make_shared<Squares>(mapping));
}

}  // namespace

FloatTexture CheckerboardTexture::CreateFloat(TextureBuilder &builder) {
    const FloatTexture board = CreateBoard(builder);
    const FloatTexture tex1 = builder.Float(kTex1);
    return Mixed(tex1, builder.Float(kTex2), board);
}

SpectrumByRole CheckerboardTexture::CreateSpectrum(TextureBuilder &builder) {
    const FloatTexture board = CreateBoard(builder);
    const SpectrumByRole tex1 = builder.Spectra(kSpectrum1);
    return Mixed(tex1, builder.Spectra(kSpectrum2), board);
}

}  // namespace pbrt
