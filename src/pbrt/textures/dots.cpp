#include "pbrt/textures/dots.h"

#include <cmath>

#include "pbrt/textures/mapping2d.h"
#include "pbrt/textures/mix.h"
#include "pbrt/textures/noise.h"

namespace pbrt {
namespace {

constexpr FloatParam kInside{"inside", "", 1, -kOpen, kOpen, "value of the dots"};
constexpr FloatParam kOutside{"outside", "", 0, -kOpen, kOpen, "value between them"};
constexpr SpectrumParam kSpectrumInside{"inside", SpectrumType::Unbounded, "1",
                                        "value of the dots"};
constexpr SpectrumParam kSpectrumOutside{"outside", SpectrumType::Unbounded, "0",
                                         "value between them"};

/// 1 within dots, 0 between them. Chance is noise at places between the lattice's points, where the
/// same dots stand as in pbrt-v4 (Pharr, Jakob, Humphreys, "Physically Based Rendering").
struct IsInDot : FloatNode {
    explicit IsInDot(TextureMapping2D mapping) : mapping(std::move(mapping)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        constexpr float kRadius = 0.35f, kFarthest = 0.5f - kRadius;
        const Point2f st = mapping.Map(ctx).st;
        const float s = std::floor(st.x + 0.5f), t = std::floor(st.y + 0.5f);
        const auto chance = [&](float ds, float dt) { return Noise({s + ds, t + dt, 0.5f}); };
        if (!(chance(0.5f, 0.5f) > 0)) return 0;
        const Point2f center{s + kFarthest * chance(1.5f, 2.8f),
                             t + kFarthest * chance(4.5f, 9.8f)};
        return Sqr(st.x - center.x) + Sqr(st.y - center.y) < Sqr(kRadius) ? 1.f : 0.f;
    }
    TextureMapping2D mapping;
};

FloatTexture CreateIsInDot(TextureBuilder &builder) {
    const auto mapping = TextureMapping2D::Create(builder.params, builder.textureFromRender);
    builder.readsUV |= mapping.ReadsUV();
    return FloatTexture(std::make_shared<IsInDot>(mapping));
}

}  // namespace

FloatTexture DotsTexture::CreateFloat(TextureBuilder &builder) {
    const FloatTexture isInDot = CreateIsInDot(builder);
    const FloatTexture outside = builder.Float(kOutside);
    return Mixed(outside, builder.Float(kInside), isInDot);
}

SpectrumByRole DotsTexture::CreateSpectrum(TextureBuilder &builder) {
    const FloatTexture isInDot = CreateIsInDot(builder);
    const SpectrumByRole outside = builder.Spectra(kSpectrumOutside);
    return Mixed(outside, builder.Spectra(kSpectrumInside), isInDot);
}

}  // namespace pbrt
