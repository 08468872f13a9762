#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "pbrt/base/light.h"
#include "pbrt/lights/diffuse_area.h"
#include "pbrt/lights/distant.h"
#include "pbrt/lights/image_infinite.h"
#include "pbrt/lights/point.h"
#include "pbrt/lights/spot.h"
#include "pbrt/lights/uniform_infinite.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of lights; base/light.h is their contract, docs/EXTENDING.md the way to a new one.
using LightTypes = TypeList<DiffuseAreaLight, PointLight, SpotLight, DistantLight,
                            UniformInfiniteLight, ImageInfiniteLight>;
using Light = LightTypes::Variant;

static_assert(LightTypes::All<LightContract>);

/// Makes what `LightSource "type"` describes. nullopt after an error (in the log). Reports unread
/// parameters.
std::optional<Light> CreateLight(std::string_view type, ParamDict &params,
                                 const Transform &renderFromLight);
/// Makes the lights of `AreaLightSource "type"` on a shape, which must outlive them: one per
/// primitive, in order. `alpha`: the shape's. Empty after an error.
std::vector<Light> CreateAreaLights(std::string_view type, ParamDict &params, const Shape &shape,
                                    const FloatTexture &alpha = 1.f);

/// Tells the light how large the scene is; once, before anything below.
void Preprocess(Light &light, const Bounds3f &sceneBounds);

// The members of base/light.h, of whichever type it is.

inline const LightTraits &Traits(const Light &light) {
    return Dispatch(light, []<typename L>(const L &) -> const LightTraits & { return L::kTraits; });
}

/// nullopt where nothing can arrive; occlusion is the caller's.
inline std::optional<LightLiSample> SampleLi(const Light &light, const LightSampleContext &ctx,
                                             Point2f u, const SampledWavelengths &lambda) {
    return Dispatch(light, [&](const auto &l) { return l.SampleLi(ctx, u, lambda); });
}

/// Density of SampleLi for the direction wi from ctx.p, which meets the area light at p, where its
/// normal is n; 0 for other lights.
inline float PDF_Hit(const Light &light, const LightSampleContext &ctx, Point3f p, Normal3f n) {
    return Dispatch(light, [&]<typename T>(const T &l) -> float {
        if constexpr (T::kTraits.isArea) return l.PDF_Hit(ctx.p, p, n);
        return 0;
    });
}
/// Radiance that leaves an area light's surface into direction w where its normal is n; 0 for other
/// lights.
inline SampledSpectrum L(const Light &light, Normal3f n, Vector3f w,
                         const SampledWavelengths &lambda) {
    return Dispatch(light, [&]<typename T>(const T &l) {
        if constexpr (T::kTraits.isArea) return l.L(n, w, lambda);
        return SampledSpectrum(0.f);
    });
}

/// Radiance along a ray of direction d that leaves the scene, and the density of SampleLi for it; 0
/// but for infinite lights.
inline LightLe Le(const Light &light, Vector3f d, const SampledWavelengths &lambda) {
    return Dispatch(light, [&]<typename T>(const T &l) -> LightLe {
        if constexpr (T::kTraits.isInfinite) return {l.Le(d, lambda), l.PDF_Li(d)};
        return {SampledSpectrum(0.f), 0};
    });
}

inline float Power(const Light &light) {
    return Dispatch(light, [](const auto &l) { return l.Power(); });
}
inline std::optional<LightBounds> Bounds(const Light &light) {
    return Dispatch(light, [](const auto &l) { return l.Bounds(); });
}

}  // namespace pbrt
