#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "pbrt/base/light.h"
#include "pbrt/lights/diffuse_area.h"
#include "pbrt/lights/distant.h"
#include "pbrt/lights/goniometric.h"
#include "pbrt/lights/image_infinite.h"
#include "pbrt/lights/point.h"
#include "pbrt/lights/portal_infinite.h"
#include "pbrt/lights/projection.h"
#include "pbrt/lights/spot.h"
#include "pbrt/lights/uniform_infinite.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of lights; base/light.h is their contract, docs/EXTENDING.md the way to a new one.
using LightTypes =
    TypeList<DiffuseAreaLight, PointLight, SpotLight, DistantLight, GoniometricLight,
             ProjectionLight, UniformInfiniteLight, ImageInfiniteLight, PortalInfiniteLight>;
using Light = LightTypes::Variant;

static_assert(LightTypes::All([]<typename L>() { return LightContract<L>::value; }));

/// Makes what `LightSource "type"` describes. nullopt after an error (in the log). Reports unread
/// parameters.
std::optional<Light> CreateLight(std::string_view type, ParamDict &params,
                                 const Transform &renderFromLight,
                                 const Transform &renderFromWorld = Transform());
/// Makes the lights of `AreaLightSource "type"` on a shape: one per
/// primitive, in order. Empty after an error.
std::vector<Light> CreateAreaLights(std::string_view type, ParamDict &params,
                                    const EmitterArguments &emitter);

/// Names of the types that a scene may use, each once.
std::vector<std::string_view> LightNames();
std::vector<std::string_view> AreaLightNames();

/// Tells the light how large the scene is; once, before anything below.
void Preprocess(Light &light, const Bounds3f &sceneBounds);

// The members of base/light.h, of whichever type it is.

inline const LightTraits &Traits(const Light &light) {
    return Dispatch(light, []<typename L>(const L &) -> const LightTraits & { return L::kTraits; });
}

/// nullopt where nothing can arrive; occlusion is the caller's.
std::optional<LightLiSample> SampleLi(const Light &light, const LightSampleContext &ctx, Point2f u,
                                      const SampledWavelengths &lambda);

/// Density of SampleLi for the direction wi from ctx.p, which meets the area light at p, where its
/// normal is n; 0 for other lights.
inline float PDF_Hit(const Light &light, const LightSampleContext &ctx, Point3f p, Normal3f n) {
    return Dispatch(light, [&]<typename T>(const T &l) -> float {
        if constexpr (T::kTraits.isArea) return l.PDF_Hit(ctx, p, n);
        return 0;
    });
}
/// Radiance that leaves an area light's surface at a hit into direction w; 0 for other lights.
inline SampledSpectrum L(const Light &light, Point3f p, Normal3f n, Point2f uv, Vector3f w,
                         const SampledWavelengths &lambda) {
    return Dispatch(light, [&]<typename T>(const T &l) {
        if constexpr (T::kTraits.isArea) return l.L(p, n, uv, w, lambda);
        return SampledSpectrum(0.f);
    });
}

/// True where L depends on uv; false but for area lights.
bool ReadsUV(const Light &light);

/// Radiance along a ray that leaves the scene; 0 but for infinite lights.
inline SampledSpectrum Le(const Light &light, const Ray &ray, const SampledWavelengths &lambda) {
    return Dispatch(light, [&]<typename T>(const T &l) {
        if constexpr (T::kTraits.dependsOnPlace)
            return l.Le(ray.o, ray.d, lambda);
        else if constexpr (T::kTraits.isInfinite)
            return l.Le(ray.d, lambda);
        return SampledSpectrum(0.f);
    });
}
/// Density of SampleLi at `from` for wi, per unit solid angle; 0 but for infinite lights (see
/// PDF_Hit).
inline float PDF_Li(const Light &light, Point3f from, Vector3f wi) {
    return Dispatch(light, [&]<typename T>(const T &l) -> float {
        if constexpr (T::kTraits.dependsOnPlace)
            return l.PDF_Li(from, wi);
        else if constexpr (T::kTraits.isInfinite)
            return l.PDF_Li(wi);
        return 0;
    });
}

float Power(const Light &light);
std::optional<LightBounds> Bounds(const Light &light);

}  // namespace pbrt
