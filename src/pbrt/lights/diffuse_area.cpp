#include "pbrt/lights/diffuse_area.h"

namespace pbrt {
namespace {

constexpr BoolParam kTwoSided{"twosided", false, "both sides of the surface emit"};

}  // namespace

std::vector<DiffuseAreaLight> DiffuseAreaLight::Create(ParamDict &params, const Shape &shape,
                                                       const FloatTexture &alpha) {
    const Emission emission = GetEmission(params, kLightRadiance);
    const EmissionScale scale = GetScale(params, kLightPower);
    const bool twoSided = params.GetOneBool(kTwoSided);
    const bool invisible = alpha.IsConstant() && alpha.Constant() == 0;
    std::optional<Rectangle> rectangle;
    if (const auto *mesh = std::get_if<BilinearMesh>(&shape)) rectangle = Rectangle::From(*mesh);
    const auto surface = std::make_shared<const Surface>(
        Surface{*emission.spectrum, emission.luminance, &shape, twoSided,
                invisible ? FloatTexture(1.f) : alpha, rectangle, invisible});
    std::vector<DiffuseAreaLight> lights(NPrimitives(shape));
    for (uint32_t i = 0; i < uint32_t(lights.size()); ++i) {
        const float flux = Pi * (twoSided ? 2 : 1) * Area(shape, i);
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
