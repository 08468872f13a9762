#include "pbrt/textures/direction_mix.h"

#include <algorithm>

#include "pbrt/textures/mix.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr PointParam kDir{"dir", "vector3", {0, 1, 0}, "where the normal points along it: tex1"};
constexpr FloatParam kTex1{"tex1", "", 0, -kOpen, kOpen, "value along dir"};
constexpr FloatParam kTex2{"tex2", "", 1, -kOpen, kOpen, "value across dir"};
constexpr SpectrumParam kSpectrum1{"tex1", SpectrumType::Unbounded, "0", "value along dir"};
constexpr SpectrumParam kSpectrum2{"tex2", SpectrumType::Unbounded, "1", "value across dir"};

/// Share of tex2, 0 to 1.
struct AcrossDirection : FloatNode {
    explicit AcrossDirection(Vector3f dir) : dir(dir) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        return std::max(0.f, 1 - std::abs(Dot(ctx.n, dir)));
    }
    Vector3f dir;  ///< unit, rendering space
};

FloatTexture CreateShare(TextureBuilder &builder) {
    const Vector3f dir = builder.params.GetOneVector3f(kDir);
    const Vector3f inRender = builder.textureFromRender.Inverse().Vector(dir);
    if (!HasSafeLength(inRender)) {
        builder.params.Error(kDir.name, "\"dir\" has no length to speak of");
        return 0.5f;
    }
    return FloatTexture(std::make_shared<AcrossDirection>(Normalize(inRender)));
}

}  // namespace

FloatTexture DirectionMixTexture::CreateFloat(TextureBuilder &builder) {
    const FloatTexture share = CreateShare(builder);
    const FloatTexture tex1 = builder.Float(kTex1);
    return Mixed(tex1, builder.Float(kTex2), share);
}

SpectrumByRole DirectionMixTexture::CreateSpectrum(TextureBuilder &builder) {
    const FloatTexture share = CreateShare(builder);
    const SpectrumByRole tex1 = builder.Spectra(kSpectrum1);
    return Mixed(tex1, builder.Spectra(kSpectrum2), share);
}

}  // namespace pbrt
