#include "pbrt/lights/diffuse_area.h"

#include "pbrt/textures/image_color_space.h"

namespace pbrt {
namespace {

constexpr BoolParam kTwoSided{"twosided", false, "both sides of the surface emit"};

/// Radiance of a surface.
struct Source {
    Spectrum radiance;
    float luminance;  ///< mean CIE-Y integral
    float ofPower;    ///< the share of it that `power` counts
    std::shared_ptr<const LightPicture> picture;
};

/// nullopt after an error.
std::optional<Source> GetSource(ParamDict &params) {
    const StringParam &row = DiffuseAreaLight::kFileName;
    if (params.GetFileName(row).empty()) {
        const Emission emission = GetEmission(params, kLightRadiance);
        return Source{*emission.spectrum, emission.luminance, 1, nullptr};
    }
    if (params.GetOneSpectrum(kLightRadiance))
        params.Error(kLightRadiance.name,
                     "both \"L\" and \"filename\" are given; an area light takes one");
    const std::optional<Image> image = ReadLightPicture(params, row, {.what = "an area light"});
    if (!image) return std::nullopt;
    auto picture = std::make_shared<const LightPicture>(*image, ColorSpaceOf(*image));
    const float mean = picture->MeanLuminance();
    return Source{picture->Illuminant(), mean, mean, std::move(picture)};
}

}  // namespace

std::vector<DiffuseAreaLight> DiffuseAreaLight::Create(ParamDict &params, const Shape &shape,
                                                       const FloatTexture &alpha) {
    const std::optional<Source> source = GetSource(params);
    const EmissionScale scale = GetScale(params, kLightPower);
    const bool twoSided = params.GetOneBool(kTwoSided);
    const bool invisible = alpha.IsConstant() && alpha.Constant() == 0;
    std::optional<Rectangle> rectangle;
    if (const auto *mesh = std::get_if<BilinearMesh>(&shape)) rectangle = Rectangle::From(*mesh);
    if (!source) return {};
    const auto surface = std::make_shared<const Surface>(
        Surface{source->radiance, source->luminance, &shape, twoSided,
                invisible ? FloatTexture(1.f) : alpha, rectangle, invisible, source->picture});
    std::vector<DiffuseAreaLight> lights(NPrimitives(shape));
    for (uint32_t i = 0; i < uint32_t(lights.size()); ++i) {
        const float flux = source->ofPower * Pi * (twoSided ? 2 : 1) * Area(shape, i);
        lights[i].surface = surface;
        lights[i].primitive = i;
        lights[i].scale = flux > 0 ? scale.For(flux) : 0;
    }
    return lights;
}

float DiffuseAreaLight::Opacity(const ShapeSample &at) const {
    TextureEvalContext ctx;
    ctx.p = at.p;
    ctx.n = at.n;
    ctx.uv = at.uv;
    return std::clamp(surface->alpha.Evaluate(ctx), 0.f, 1.f);
}

float DiffuseAreaLight::Power() const {
    return Pi * (surface->twoSided ? 2 : 1) * scale * surface->luminance *
           Area(*surface->shape, primitive);
}

std::optional<LightBounds> DiffuseAreaLight::Bounds() const {
    const NormalCone cone = NormalBounds(*surface->shape, primitive);
    return LightBounds{PrimitiveBounds(*surface->shape, primitive),
                       {cone.axis, cone.cosTheta},
                       0,
                       Power(),
                       surface->twoSided};
}

}  // namespace pbrt
