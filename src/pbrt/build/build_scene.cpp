#include "pbrt/build/build_scene.h"

#include <fmt/format.h>

#include "pbrt/build/build_shapes.h"
#include "pbrt/build/instance_range.h"
#include "pbrt/shapes/parallelogram.h"

namespace pbrt {
namespace {

ParamDict Params(const Entity &entity, std::string_view kind, std::string_view type,
                 const SceneDescription &description, Diagnostics &log) {
    return ParamDict(entity.params, entity.loc, fmt::format("{} \"{}\"", kind, type),
                     entity.colorSpace, &log, description.dir);
}

constexpr std::array<std::string_view, 2> kAccelerators{"bvh", "kdtree"};
constexpr std::array<std::string_view, 4> kSplitMethods{"sah", "middle", "equal", "hlbvh"};
constexpr ChoiceParam kSplitMethod{"splitmethod", kSplitMethods[0], kSplitMethods,
                                   "no effect: the ray tracer chooses"};
constexpr IntParam kMaxNodePrims{"maxnodeprims", 4, 1, 255, "no effect: the ray tracer chooses"};
constexpr std::string_view kNoTree = "no effect: the ray tracer builds a bvh";
constexpr IntParam kIntersectCost{"intersectcost", 5, kLeastInt, kMostInt, kNoTree};
constexpr IntParam kTraversalCost{"traversalcost", 1, kLeastInt, kMostInt, kNoTree};
constexpr FloatParam kEmptyBonus{"emptybonus", "", 0.5f, -kOpen, kOpen, kNoTree};
constexpr IntParam kMaxPrims{"maxprims", 1, kLeastInt, kMostInt, kNoTree};
constexpr IntParam kTreeDepth{"maxdepth", -1, kLeastInt, kMostInt, kNoTree};

void ReadSampling(const SceneDescription &description, const SceneOverrides &overrides,
                  RenderScene &scene, Diagnostics &log) {
    const std::string filterType =
        description.filter.type.empty() ? "gaussian" : description.filter.type;
    ParamDict filterParams = Params(description.filter, "filter", filterType, description, log);
    if (const auto filter = CreateFilter(filterParams, filterType)) scene.filter = *filter;

    const std::string type = description.sampler.type.empty() ? "zsobol" : description.sampler.type;
    ParamDict params = Params(description.sampler, "sampler", type, description, log);
    std::optional<int> spp = overrides.spp;
    if (!spp && overrides.film.quick && type != "independent") spp = 1;
    if (const auto sampler =
            CreateSampler(params, type, spp, description.options.seed, scene.film.FullResolution()))
        scene.sampler = *sampler;
}

/// Two triangles that make a parallelogram, as one patch: one light is chosen and sampled better
/// than two. Not where `power` is given, which is each triangle's (PBRT_FORMAT 2.10), nor where a
/// picture is, which lies by the triangles' uv.
std::optional<BilinearMesh> MergedEmitter(const Geometry &geometry, ParamDict &params) {
    const auto *mesh = std::get_if<TriangleMesh>(&geometry.shape);
    if (!mesh || params.Has(kLightPower) || params.Has(DiffuseAreaLight::kFileName) ||
        !geometry.alpha.IsConstant())
        return {};
    return AsParallelogram(*mesh);
}

void BuildLights(const SceneDescription &description, const std::vector<EmissiveShape> &emitters,
                 RenderScene &scene, Diagnostics &log) {
    const Transform &renderFromWorld = Placement(scene.camera).renderFromWorld;
    for (const LightEntity &entity : description.lights) {
        ParamDict params = Params(entity, "light", entity.type, description, log);
        if (auto light = CreateLight(entity.type, params, renderFromWorld * entity.worldFromLight,
                                     renderFromWorld))
            scene.lights.push_back(std::move(*light));
    }
    LightPictures pictures;
    for (const EmissiveShape &emitter : emitters) {
        Geometry &geometry = scene.geometries[emitter.geometry];
        ParamDict params =
            Params(*emitter.areaLight, "area light", emitter.areaLight->type, description, log);
        const Instance *const motion =
            emitter.instance < 0 ? nullptr : &scene.instances[size_t(emitter.instance)];
        const std::optional<BilinearMesh> merged = MergedEmitter(geometry, params);
        if (merged) scene.emitterShapes.push_back(*merged);
        geometry.sharedLight = merged.has_value();
        std::vector<Light> made =
            CreateAreaLights(emitter.areaLight->type, params,
                             {merged ? scene.emitterShapes.back() : geometry.shape, geometry.alpha,
                              motion, &pictures});
        if (made.empty()) continue;
        // Alpha 0 everywhere: a light that is sampled but never seen.
        geometry.firstLight = int(scene.lights.size());
        std::move(made.begin(), made.end(), std::back_inserter(scene.lights));
    }
    Bounds3f bounds = scene.accel->WorldBounds();
    if (bounds.Empty()) bounds = {{-1, -1, -1}, {1, 1, 1}};
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        Preprocess(scene.lights[i], bounds);
        if (Traits(scene.lights[i]).isInfinite) scene.infiniteLights.push_back(int(i));
    }
}

}  // namespace

std::span<const std::string_view> AcceleratorNames() {
    return kAccelerators;
}

void ReadAccelerator(std::string_view type, ParamDict &params) {
    if (type == "bvh") {
        params.GetOneChoice(kSplitMethod);
        params.GetOneInt(kMaxNodePrims);
    } else if (type == "kdtree") {
        params.GetOneInt(kIntersectCost);
        params.GetOneInt(kTraversalCost);
        params.GetOneFloat(kEmptyBonus);
        params.GetOneInt(kMaxPrims);
        params.GetOneInt(kTreeDepth);
    } else {
        return params.Error(UnknownName("accelerator", type, kAccelerators));
    }
    params.ReportUnused();
}

std::unique_ptr<RenderScene> BuildScene(SceneDescription &&description,
                                        const SceneOverrides &overrides, Diagnostics &log) {
    auto scene = std::make_unique<RenderScene>();
    scene->options = description.options;
    scene->film = Film::Create(description, overrides.film, log);
    scene->camera = CreateCamera(description, scene->film.FullResolution(), log);
    const CameraPlacement &placement = Placement(scene->camera);
    scene->isAnimated = placement.Moves();
    scene->film.SetSpaces(placement.renderFromCamera.Inverse(),
                          placement.renderFromWorld.Inverse());
    scene->film.SetExposure(placement.shutterClose - placement.shutterOpen);
    ReadSampling(description, overrides, *scene, log);
    if (const Entity &accelerator = description.accelerator; !accelerator.type.empty()) {
        ParamDict params = Params(accelerator, "accelerator", accelerator.type, description, log);
        ReadAccelerator(accelerator.type, params);
    }

    const NamedTextures textures = BuildTextures(description, placement.renderFromWorld, log);
    MaterialTable materials = BuildMaterials(description, textures, *scene, log);
    // Reliefs take their differences over half a pixel.
    scene->filtersTextures = (textures.readFootprints || scene->materials.AnyBump()) &&
                             !description.options.disableTextureFiltering;
    const BuiltShapes shapes = BuildShapes(description, textures, materials, *scene, log);
    if (log.HasErrors()) return nullptr;

    const uint32_t nTop = scene->TopLevelGeometries();
    scene->accel.emplace(scene->geometries, nTop, scene->objects, scene->instances,
                         overrides.nThreads);
    if (!scene->accel->Error().empty()) {
        log.Error({}, scene->accel->Error());
        return nullptr;
    }
    BuildLights(description, shapes.emitters, *scene, log);
    CheckRaysInInstances(*scene, shapes.instances, log);
    if (log.HasErrors()) return nullptr;
    return scene;
}

}  // namespace pbrt
