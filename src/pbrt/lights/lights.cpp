#include "pbrt/lights/lights.h"

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/lights/from_to.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

/// Names of the lights that are (or are not) area lights, as the list has them.
std::vector<std::string_view> NamesOf(bool area) {
    std::vector<std::string_view> names;
    LightTypes::ForEach([&]<typename L>() {
        if (L::kTraits.isArea == area &&
            std::find(names.begin(), names.end(), L::kName) == names.end())
            names.push_back(L::kName);
    });
    return names;
}

/// True if directions keep lengths to normalise by on their way to the light and back.
bool KeepsDirections(const Transform &t) {
    for (const Vector3f &axis : {Vector3f{1, 0, 0}, Vector3f{0, 1, 0}, Vector3f{0, 0, 1}})
        if (!HasSafeLength(t.Vector(axis)) || !HasSafeLength(t.Inverse().Vector(axis)))
            return false;
    return true;
}

// What a Create may return.

template <LightType L>
std::optional<Light> AsLight(const L &made) {
    return Light(made);
}
template <typename... L>
std::optional<Light> AsLight(const std::variant<L...> &made) {
    return Dispatch(made, [](const auto &light) { return AsLight(light); });
}
template <typename Made>
std::optional<Light> AsLight(const std::optional<Made> &made) {
    return made ? AsLight(*made) : std::nullopt;
}

/// Light of the first type of that name; nullopt after an error.
std::optional<Light> CreateNamed(std::string_view type, ParamDict &params,
                                 const Transform &renderFromLight,
                                 const Transform &renderFromWorld) {
    std::optional<Light> light;
    bool found = false;
    LightTypes::ForEach([&]<typename L>() {
        if constexpr (!L::kTraits.isArea) {
            if (found || L::kName != type) return;
            found = true;
            if constexpr (requires { L::Create(params, renderFromLight, renderFromWorld); })
                light = AsLight(L::Create(params, renderFromLight, renderFromWorld));
            else
                light = AsLight(L::Create(params, renderFromLight));
        }
    });
    return light;
}

}  // namespace

std::vector<std::string_view> LightNames() {
    return NamesOf(false);
}
std::vector<std::string_view> AreaLightNames() {
    return NamesOf(true);
}

std::optional<Light> CreateLight(std::string_view type, ParamDict &params,
                                 const Transform &renderFromLight,
                                 const Transform &renderFromWorld) {
    const std::vector<std::string_view> names = LightNames();
    if (std::find(names.begin(), names.end(), type) == names.end()) {
        params.Error(UnknownName("light", type, names));
        return std::nullopt;
    }
    if (!KeepsDirections(renderFromLight)) {
        params.Error(
            fmt::format("light \"{}\": its transformation scales by less than {:g} or more "
                        "than {:g}",
                        type, kShortestVector, kLongestVector));
        return std::nullopt;
    }
    std::optional<Light> light = CreateNamed(type, params, renderFromLight, renderFromWorld);
    const auto place = light ? Bounds(*light) : std::nullopt;
    if (place && !IsInRange(place->bounds))
        params.Error(kLightFrom.name,
                     fmt::format("light \"{}\" stands beyond {:g}, up to where light can "
                                 "be traced",
                                 type, kFarthest));
    params.ReportUnused();
    return light;
}

std::vector<Light> CreateAreaLights(std::string_view type, ParamDict &params,
                                    const EmitterArguments &emitter) {
    std::vector<Light> lights;
    bool found = false;
    LightTypes::ForEach([&]<typename L>() {
        if constexpr (L::kTraits.isArea) {
            if (found || L::kName != type) return;
            found = true;
            const std::vector<L> made = L::Create(params, emitter);
            lights.assign(made.begin(), made.end());
        }
    });
    if (!found) {
        params.Error(UnknownName("area light", type, AreaLightNames()));
        return {};
    }
    params.ReportUnused();
    return lights;
}

void Preprocess(Light &light, const Bounds3f &sceneBounds) {
    const float radius = Length(sceneBounds.Diagonal()) / 2;
    Dispatch(light, [&]<typename L>(L &l) {
        if constexpr (L::kTraits.readsSceneRadius) l.Preprocess(radius);
    });
}

std::optional<LightLiSample> SampleLi(const Light &light, const LightSampleContext &ctx, Point2f u,
                                      const SampledWavelengths &lambda) {
    return Dispatch(light, [&](const auto &l) { return l.SampleLi(ctx, u, lambda); });
}
float Power(const Light &light) {
    return Dispatch(light, [](const auto &l) { return l.Power(); });
}
std::optional<LightBounds> Bounds(const Light &light) {
    return Dispatch(light, [](const auto &l) { return l.Bounds(); });
}

bool ReadsUV(const Light &light) {
    return Dispatch(light, []<typename T>(const T &l) -> bool {
        if constexpr (T::kTraits.isArea) return l.ReadsUV();
        return false;
    });
}

}  // namespace pbrt
