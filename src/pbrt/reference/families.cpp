#include "pbrt/reference/families.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pbrt/build/build_scene.h"
#include "pbrt/build/build_shapes.h"
#include "pbrt/integrators/integrators.h"
#include "pbrt/materials/materials.h"
#include "pbrt/materials/mix.h"
#include "pbrt/textures/textures.h"

namespace pbrt::reference {
namespace {

using Names = std::vector<std::string_view>;

Names From(std::span<const std::string_view> names) {
    return {names.begin(), names.end()};
}

/// The resolution of a film that is not told another one.
constexpr Point2i kResolution{1280, 720};

void CreateNamedShape(std::string_view type, ParamDict &params) {
    ShapeEntity entity;
    entity.type = type;
    GetAlpha(params, {});
    CreateShapes(entity, params, Transform());
}

void CreateNamedMaterial(std::string_view type, ParamDict &params) {
    if (type == InterfaceMaterial::kName) return;
    if (type != MixMaterial::kName) {
        CreateMaterial(type, params, {});
        return;
    }
    MixMaterial::Create(params, {}, {});
    params.ReportUnused();
}

void CreateTexture(std::string_view type, ParamDict &params, bool isFloat) {
    NamedTextures none;
    TextureBuilder builder{params, none, Transform()};
    TextureTypes::Visit(type, [&]<typename T>() {
        if (isFloat)
            T::CreateFloat(builder);
        else if constexpr (SpectrumTextureType<T>)
            T::CreateSpectrum(builder);
    });
    params.ReportUnused();
}

constexpr std::array kFamilies{
    Family{"film", "Film", [] { return From(FilmTypes::kNames); },
           [](std::string_view type, ParamDict &params) { Film::Create(type, params, {}); }},
    Family{"camera", "Camera", [] { return From(CameraTypes::kNames); },
           [](std::string_view type, ParamDict &params) {
               CreateCamera(type, params, SceneDescription(), kResolution);
           }},
    Family{"sampler", "Sampler", [] { return From(SamplerTypes::kNames); },
           [](std::string_view type, ParamDict &params) {
               CreateSampler(params, type, {}, 0, kResolution);
           }},
    Family{"filter", "PixelFilter", [] { return From(FilterTypes::kNames); },
           [](std::string_view type, ParamDict &params) { CreateFilter(params, type); }},
    Family{"integrator", "Integrator", [] { return IntegratorNames(); },
           [](std::string_view type, ParamDict &params) { CreateIntegrator(type, params); }},
    Family{"accelerator", "Accelerator", [] { return From(AcceleratorNames()); },
           [](std::string_view type, ParamDict &params) { ReadAccelerator(type, params); }},
    Family{"shape", "Shape", [] { return From(ShapeDirectives::kNames); }, CreateNamedShape},
    Family{
        "light", "LightSource", [] { return LightNames(); },
        [](std::string_view type, ParamDict &params) { CreateLight(type, params, Transform()); }},
    Family{
        "area light", "AreaLightSource", [] { return AreaLightNames(); },
        [](std::string_view type, ParamDict &params) { CreateAreaLights(type, params, {Sphere()}); }},
    Family{"material", "Material", [] { return MaterialNames(); }, CreateNamedMaterial},
    Family{"float texture", "Texture \"name\" \"float\"", [] { return From(TextureTypes::kNames); },
           [](std::string_view type, ParamDict &params) { CreateTexture(type, params, true); }},
    Family{"spectrum texture", "Texture \"name\" \"spectrum\"",
           [] { return SpectrumTextureNames(); },
           [](std::string_view type, ParamDict &params) { CreateTexture(type, params, false); }},
};

bool IsSameRow(const RequestedParam &a, const RequestedParam &b) {
    return NameOf(a.row) == NameOf(b.row) && TypesOf(a) == TypesOf(b);
}

ParsedParameter Chosen(const ChoiceParam &row, std::string_view value) {
    ParsedParameter p;
    p.type = "string";
    p.name = row.name;
    p.strings = {std::string(value)};
    return p;
}

}  // namespace

std::span<const Family> Families() {
    return kFamilies;
}

Trial Create(const Family &family, std::string_view type, ParsedParameters given) {
    Diagnostics log;
    ParamDict params(std::move(given), {}, fmt::format("{} \"{}\"", family.name, type),
                     &RGBColorSpace::sRGB(), &log);
    family.create(type, params);
    return {params.Requested(), log.Messages()};
}

std::vector<RequestedParam> ParametersOf(const Family &family, std::string_view type) {
    const std::vector<RequestedParam> plain = Create(family, type, {}).requested;
    std::vector<RequestedParam> all = plain;
    for (const RequestedParam &param : plain) {
        const auto *const choice = std::get_if<ChoiceParam>(&param.row);
        if (!choice) continue;
        for (const std::string_view value : choice->allowed)
            for (const RequestedParam &more :
                 Create(family, type, {Chosen(*choice, value)}).requested)
                if (std::none_of(all.begin(), all.end(), [&](const RequestedParam &known) {
                        return IsSameRow(known, more);
                    }))
                    all.push_back(more);
    }
    return all;
}

}  // namespace pbrt::reference
