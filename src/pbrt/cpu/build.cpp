#include "pbrt/cpu/build.h"

#include <fmt/format.h>

#include "pbrt/cpu/build_shapes.h"
#include "pbrt/cpu/instance_range.h"

namespace pbrt {
namespace {

ParamDict Params(const Entity &entity, std::string_view kind, std::string_view type,
                 const Description &scene, Diagnostics &log) {
    return ParamDict(entity.params, entity.loc, fmt::format("{} \"{}\"", kind, type),
                     entity.colorSpace, &log, scene.dir);
}

constexpr std::array<std::string_view, 2> kIntegrators{"volpath", "path"};
constexpr std::array<std::string_view, 1> kAccelerators{"bvh"};
constexpr std::array<std::string_view, 4> kSplitMethods{"sah", "middle", "equal", "hlbvh"};

struct IntegratorChoice {
    PathSettings path;
    std::string lightSampler = "bvh";
};

IntegratorChoice ReadIntegrator(const Description &scene, Diagnostics &log) {
    IntegratorChoice choice;
    const std::string type = scene.integrator.type.empty() ? "volpath" : scene.integrator.type;
    ParamDict params = Params(scene.integrator, "integrator", type, scene, log);
    if (std::find(kIntegrators.begin(), kIntegrators.end(), type) == kIntegrators.end()) {
        params.Error(UnknownName("integrator", type, kIntegrators));
        return choice;
    }
    choice.path.maxDepth = params.GetOneInt("maxdepth", 5, 0, 1 << 20);
    choice.path.regularize = params.GetOneBool("regularize", false);
    const int which = params.GetOneChoice("lightsampler", "bvh", kLightSamplerNames);
    choice.lightSampler = kLightSamplerNames[which];
    params.ReportUnused();
    return choice;
}

/// Embree chooses for itself: pbrt's hints are checked and have no effect.
void ReadAccelerator(const Description &scene, Diagnostics &log) {
    if (scene.accelerator.type.empty()) return;
    ParamDict params = Params(scene.accelerator, "accelerator", scene.accelerator.type, scene, log);
    if (scene.accelerator.type != kAccelerators[0]) {
        params.Error(UnknownName("accelerator", scene.accelerator.type, kAccelerators));
        return;
    }
    params.GetOneChoice("splitmethod", "sah", kSplitMethods);
    params.GetOneInt("maxnodeprims", 4, 1, 255);
    params.ReportUnused();
}

void ReadSampling(const Description &scene, const Overrides &overrides, World &world,
                  Diagnostics &log) {
    const std::string filterType = scene.filter.type.empty() ? "gaussian" : scene.filter.type;
    ParamDict filterParams = Params(scene.filter, "filter", filterType, scene, log);
    if (const auto filter = CreateFilter(filterParams, filterType)) world.filter = *filter;

    const std::string type = scene.sampler.type.empty() ? "zsobol" : scene.sampler.type;
    ParamDict params = Params(scene.sampler, "sampler", type, scene, log);
    std::optional<int> spp = overrides.spp;
    if (!spp && overrides.film.quick && type != "independent") spp = 1;
    if (const auto sampler =
            CreateSampler(params, type, spp, scene.options.seed, world.film.FullResolution()))
        world.sampler = *sampler;
    world.targetError = overrides.targetError;
}

/// Two triangles that make a parallelogram, as one patch: one light is chosen and sampled better
/// than two. Not where `power` is given, which is each triangle's (PBRT_FORMAT 2.10).
std::optional<Shape> MergedEmitter(const Geometry &geometry, ParamDict &params) {
    const auto *mesh = std::get_if<TriangleMesh>(&geometry.shape);
    if (!mesh || params.Has("power") || !geometry.alpha.IsConstant()) return {};
    return AsParallelogram(*mesh);
}

void BuildLights(const Description &scene, const std::string &lightSampler,
                 const std::vector<EmissiveShape> &emitters, World &world, Diagnostics &log) {
    const Transform &renderFromWorld = world.camera.RenderFromWorld();
    for (const LightEntity &entity : scene.lights) {
        ParamDict params = Params(entity, "light", entity.type, scene, log);
        if (auto light = CreateLight(entity.type, params, renderFromWorld * entity.worldFromLight))
            world.lights.push_back(std::move(*light));
    }
    for (const EmissiveShape &emitter : emitters) {
        Geometry &geometry = world.geometries[emitter.geometry];
        ParamDict params =
            Params(*emitter.areaLight, "area light", emitter.areaLight->type, scene, log);
        const std::optional<Shape> merged = MergedEmitter(geometry, params);
        if (merged) world.emitterShapes.push_back(*merged);
        geometry.oneLight = merged.has_value();
        std::vector<Light> made =
            CreateAreaLights(emitter.areaLight->type, params,
                             merged ? world.emitterShapes.back() : geometry.shape, geometry.alpha);
        if (made.empty()) continue;
        // Alpha 0 everywhere: a light that is sampled but never seen.
        geometry.firstLight = int(world.lights.size());
        std::move(made.begin(), made.end(), std::back_inserter(world.lights));
    }
    Bounds3f bounds = world.accel->WorldBounds();
    if (bounds.Empty()) bounds = {{-1, -1, -1}, {1, 1, 1}};
    for (size_t i = 0; i < world.lights.size(); ++i) {
        Preprocess(world.lights[i], bounds);
        if (IsInfinite(world.lights[i])) world.infiniteLights.push_back(int(i));
    }
    world.lightSampler = LightSampler::Create(lightSampler, world.lights);
    if (world.lights.empty() && !log.HasErrors())
        log.Warning({}, "no light sources in the scene: the picture is black");
}

}  // namespace

std::unique_ptr<World> BuildWorld(Description &scene, const Overrides &overrides,
                                  Diagnostics &log) {
    auto world = std::make_unique<World>();
    world->options = scene.options;
    world->film = Film::Create(scene, overrides.film, log);
    world->camera = Camera::Create(scene, world->film.FullResolution(), log);
    world->film.SetSpaces(world->camera.RenderFromCamera().Inverse(),
                          world->camera.RenderFromWorld().Inverse());
    world->film.SetExposure(world->camera.ShutterClose() - world->camera.ShutterOpen());
    ReadSampling(scene, overrides, *world, log);
    const IntegratorChoice integrator = ReadIntegrator(scene, log);
    world->path = integrator.path;
    ReadAccelerator(scene, log);

    const NamedTextures textures = BuildTextures(scene, world->camera.RenderFromWorld(), log);
    world->filtersTextures = textures.readFootprints && !scene.options.disableTextureFiltering;
    MaterialTable materials = BuildMaterials(scene, textures, *world, log);
    for (const Material &m : world->materials)
        world->plain.push_back(IsPlain(m));
    const BuiltShapes shapes = BuildShapes(scene, textures, materials, *world, log);
    if (log.HasErrors()) return nullptr;

    const uint32_t nTop = world->TopLevelGeometries();
    world->accel.emplace(world->geometries, nTop, world->objects, world->instances,
                         overrides.nThreads);
    if (!world->accel->Error().empty()) {
        log.Error({}, world->accel->Error());
        return nullptr;
    }
    BuildLights(scene, integrator.lightSampler, shapes.emitters, *world, log);
    CheckRaysInInstances(*world, shapes.instances, log);
    if (log.HasErrors()) return nullptr;
    return world;
}

}  // namespace pbrt
