#include "pbrt/lights/lights.h"

#include <fmt/format.h>

#include "pbrt/lights/from_to.h"
#include "pbrt/lights/infinite.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 4> kNames{PointLight::kName, SpotLight::kName,
                                                 DistantLight::kName, UniformInfiniteLight::kName};
constexpr std::array<std::string_view, 1> kAreaNames{DiffuseAreaLight::kName};

/// True if directions keep lengths to normalise by on their way to the light and back.
bool KeepsDirections(const Transform &t) {
    for (const Vector3f &axis : {Vector3f{1, 0, 0}, Vector3f{0, 1, 0}, Vector3f{0, 0, 1}})
        if (!HasSafeLength(t.Vector(axis)) || !HasSafeLength(t.Inverse().Vector(axis)))
            return false;
    return true;
}

std::optional<Light> CreateNamed(std::string_view type, ParamDict &params,
                                 const Transform &renderFromLight) {
    if (type == PointLight::kName) return PointLight::Create(params, renderFromLight);
    if (type == SpotLight::kName) return SpotLight::Create(params, renderFromLight);
    if (type == DistantLight::kName) return DistantLight::Create(params, renderFromLight);
    const auto infinite = CreateInfiniteLight(params, renderFromLight);
    if (!infinite) return std::nullopt;
    return std::visit([](const auto &light) { return Light(light); }, *infinite);
}

}  // namespace

std::span<const std::string_view> LightNames() {
    return kNames;
}
std::span<const std::string_view> AreaLightNames() {
    return kAreaNames;
}

std::optional<Light> CreateLight(std::string_view type, ParamDict &params,
                                 const Transform &renderFromLight) {
    if (std::find(kNames.begin(), kNames.end(), type) == kNames.end()) {
        params.Error(UnknownName("light", type, kNames));
        return std::nullopt;
    }
    if (!KeepsDirections(renderFromLight)) {
        params.Error(
            fmt::format("light \"{}\": its transformation scales by less than {:g} or more "
                        "than {:g}",
                        type, kShortestVector, kLongestVector));
        return std::nullopt;
    }
    std::optional<Light> light = CreateNamed(type, params, renderFromLight);
    const auto place = light ? Bounds(*light) : std::nullopt;
    if (place && !IsInRange(place->bounds))
        params.Error(kLightFrom.name,
                     fmt::format("light \"{}\" stands beyond {:g}, up to where light can "
                                 "be traced",
                                 type, kFarthest));
    params.ReportUnused();
    return light;
}

std::vector<Light> CreateAreaLights(std::string_view type, ParamDict &params, const Shape &shape,
                                    const FloatTexture &alpha) {
    if (type != DiffuseAreaLight::kName) {
        params.Error(UnknownName("area light", type, kAreaNames));
        return {};
    }
    const std::vector<DiffuseAreaLight> made = DiffuseAreaLight::Create(params, shape, alpha);
    params.ReportUnused();
    return {made.begin(), made.end()};
}

void Preprocess(Light &light, const Bounds3f &sceneBounds) {
    const float radius = Length(sceneBounds.Diagonal()) / 2;
    std::visit(
        [&](auto &l) {
            if constexpr (requires { l.Preprocess(radius); }) l.Preprocess(radius);
        },
        light);
}

}  // namespace pbrt
