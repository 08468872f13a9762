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

/// The picture of kFileName, read where `known` has it not; null after an error.
std::shared_ptr<const LightPicture> GetPicture(ParamDict &params, LightPictures *known) {
    const StringParam &row = DiffuseAreaLight::kFileName;
    const std::string file = params.GetFileName(row);
    if (known)
        if (const auto found = known->find(file); found != known->end()) return found->second;
    std::shared_ptr<const LightPicture> picture;
    if (const auto image = ReadLightPicture(params, row, {.what = "an area light"}))
        picture = std::make_shared<const LightPicture>(*image, ColorSpaceOf(*image));
    if (known) (*known)[file] = picture;
    return picture;
}

/// nullopt after an error.
std::optional<Source> GetSource(ParamDict &params, LightPictures *pictures) {
    if (params.GetFileName(DiffuseAreaLight::kFileName).empty()) {
        const Emission emission = GetEmission(params, kLightRadiance);
        return Source{*emission.spectrum, emission.luminance, 1, nullptr};
    }
    if (params.GetOneSpectrum(kLightRadiance))
        params.Error(kLightRadiance.name,
                     "both \"L\" and \"filename\" are given; an area light takes one");
    auto picture = GetPicture(params, pictures);
    if (!picture) return std::nullopt;
    const float mean = picture->MeanLuminance();
    return Source{picture->Illuminant(), mean, mean, std::move(picture)};
}

}  // namespace

std::vector<DiffuseAreaLight> DiffuseAreaLight::Create(ParamDict &params,
                                                       const EmitterArguments &emitter) {
    const auto &[shape, alpha, motion, pictures] = emitter;
    const std::optional<Source> source = GetSource(params, pictures);
    const EmissionScale scale = GetScale(params, kLightPower);
    const bool twoSided = params.GetOneBool(kTwoSided);
    const bool invisible = alpha.IsConstant() && alpha.Constant() == 0;
    std::optional<Rectangle> rectangle;
    if (const auto *mesh = std::get_if<BilinearMesh>(&shape); mesh && !motion)
        rectangle = Rectangle::From(*mesh);
    if (!source) return {};
    if (source->ofPower == 0 && scale.target > 0)
        params.WarningOnce(kLightPower.name,
                           "the area light's picture is black: it gives none of its \"power\"");
    const auto surface = std::make_shared<const Surface>(Surface{
        source->radiance, source->luminance, &shape, twoSided,
        invisible ? FloatTexture(1.f) : alpha, rectangle, invisible, source->picture, motion});
    std::vector<DiffuseAreaLight> lights(NPrimitives(shape));
    for (uint32_t i = 0; i < uint32_t(lights.size()); ++i) {
        lights[i].surface = surface;
        lights[i].primitive = i;
        const float flux = source->ofPower * Pi * (twoSided ? 2 : 1) * lights[i].EmittingArea();
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
    return Pi * (surface->twoSided ? 2 : 1) * scale * surface->luminance * EmittingArea();
}

float DiffuseAreaLight::EmittingArea() const {
    const Surface &s = *surface;
    return s.motion ? AreaCarried(*s.shape, primitive, s.motion->Key(0))
                    : Area(*s.shape, primitive);
}

std::optional<LightBounds> DiffuseAreaLight::Bounds() const {
    const Surface &s = *surface;
    const NormalCone cone = s.motion ? NormalBoundsCarried(*s.shape, primitive, *s.motion)
                                     : NormalBounds(*s.shape, primitive);
    const Bounds3f bounds = s.motion ? BoundsCarried(*s.shape, primitive, *s.motion)
                                     : PrimitiveBounds(*s.shape, primitive);
    return LightBounds{bounds, {cone.axis, cone.cosTheta}, 0, Power(), s.twoSided};
}

}  // namespace pbrt
