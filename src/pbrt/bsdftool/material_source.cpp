#include "pbrt/bsdftool/material_source.h"

#include <fmt/format.h>

#include <filesystem>

namespace pbrt::bsdftool {
namespace {

/// The earliest of the scene's materials, named or not.
const Entity *FirstMaterial(const Description &scene) {
    const Entity *first = scene.materials.empty() ? nullptr : &scene.materials.front();
    if (scene.namedMaterials.empty()) return first;
    const Entity *named = &scene.namedMaterials.front();
    const auto place = [](const Entity *e) { return std::pair(e->loc.line, e->loc.column); };
    return !first || place(named) < place(first) ? named : first;
}

}  // namespace

std::optional<MaterialSource> ReadMaterial(const std::string &source, Diagnostics &log) {
    Description scene;
    if (std::filesystem::is_regular_file(source))
        ParseFiles({source}, scene, log);
    else
        ParseString("WorldBegin " + source, "<material>", ".", scene, log);
    if (log.HasErrors()) return {};
    const Entity *entity = FirstMaterial(scene);
    if (!entity) {
        log.Error({}, fmt::format("no material in \"{}\": give a directive such as 'Material "
                                  "\"featherbarbule\"', or a scene file",
                                  source));
        return {};
    }
    const NamedTextures textures = BuildTextures(scene, Transform(), log);
    ParamDict params(entity->params, entity->loc, fmt::format("material \"{}\"", entity->type),
                     entity->colorSpace, &log, scene.dir);
    if (entity != (scene.materials.empty() ? nullptr : &scene.materials.front()))
        params.GetOneString("type", "");  // of MakeNamedMaterial
    if (entity->type == InterfaceMaterial::kName) {
        log.Error(entity->loc, "an interface scatters nothing");
        return {};
    }
    std::optional<Material> material = CreateMaterial(entity->type, params, textures);
    if (!material || log.HasErrors()) return {};
    return MaterialSource{entity->type, std::move(*material)};
}

}  // namespace pbrt::bsdftool
