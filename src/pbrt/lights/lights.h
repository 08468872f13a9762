#pragma once

#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "pbrt/lights/diffuse_area.h"
#include "pbrt/lights/distant.h"
#include "pbrt/lights/image_infinite.h"
#include "pbrt/lights/point.h"
#include "pbrt/lights/spot.h"
#include "pbrt/lights/uniform_infinite.h"

namespace pbrt {

/// The closed set of lights. A new one: its header, its place here, its line in lights.cpp.
using Light = std::variant<DiffuseAreaLight, PointLight, SpotLight, DistantLight,
                           UniformInfiniteLight, ImageInfiniteLight>;

/// Makes what `LightSource "type"` describes. nullopt after an error (in the log). Reports unread
/// parameters.
std::optional<Light> CreateLight(std::string_view type, ParamDict &params,
                                 const Transform &renderFromLight);
/// Makes the lights of `AreaLightSource "type"` on a shape, which must outlive them: one per
/// primitive, in order. `alpha`: the shape's. Empty after an error.
std::vector<Light> CreateAreaLights(std::string_view type, ParamDict &params, const Shape &shape,
                                    const FloatTexture &alpha = 1.f);
std::span<const std::string_view> LightNames();
std::span<const std::string_view> AreaLightNames();

/// Tells the light how large the scene is; once, before anything below.
void Preprocess(Light &light, const Bounds3f &sceneBounds);

/// True where rays that leave the scene see it (Le).
inline bool IsInfinite(const Light &light) {
    return std::holds_alternative<UniformInfiniteLight>(light) ||
           std::holds_alternative<ImageInfiniteLight>(light);
}

/// nullopt where nothing can arrive; occlusion is the caller's.
inline std::optional<LightLiSample> SampleLi(const Light &light, const LightSampleContext &ctx,
                                             Point2f u, const SampledWavelengths &lambda) {
    return std::visit([&](const auto &l) { return l.SampleLi(ctx, u, lambda); }, light);
}

/// Density of SampleLi for wi, per unit solid angle; 0 but for infinite lights (see PDF_Hit).
inline float PDF_Li(const Light &light, const LightSampleContext &, Vector3f wi) {
    const auto *image = std::get_if<ImageInfiniteLight>(&light);
    return image ? image->PDF_Li(wi) : 0;
}

/// Density of SampleLi for the direction wi from ctx.p, which meets the area light at p, where its
/// normal is n.
inline float PDF_Hit(const Light &light, const LightSampleContext &ctx, Vector3f wi, Point3f p,
                     Normal3f n) {
    const auto *area = std::get_if<DiffuseAreaLight>(&light);
    return area ? area->PDF(ctx.p, wi, p, n) : 0;
}

/// Radiance along a ray that leaves the scene.
inline SampledSpectrum Le(const Light &light, const Ray &ray, const SampledWavelengths &lambda) {
    if (const auto *uniform = std::get_if<UniformInfiniteLight>(&light))
        return uniform->Le(ray.d, lambda);
    if (const auto *image = std::get_if<ImageInfiniteLight>(&light))
        return image->Le(ray.d, lambda);
    return SampledSpectrum(0.f);
}

/// Radiance that leaves an area light's surface at a hit into direction w.
inline SampledSpectrum L(const Light &light, Point3f, Normal3f n, Point2f, Vector3f w,
                         const SampledWavelengths &lambda) {
    const auto *area = std::get_if<DiffuseAreaLight>(&light);
    return area ? area->L(n, w, lambda) : SampledSpectrum(0.f);
}

inline float Power(const Light &light) {
    return std::visit([](const auto &l) { return l.Power(); }, light);
}
inline std::optional<LightBounds> Bounds(const Light &light) {
    return std::visit([](const auto &l) { return l.Bounds(); }, light);
}

}  // namespace pbrt
