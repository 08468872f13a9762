#include <fmt/format.h>

#include <unordered_map>

#include "pbrt/cpu/build_shapes.h"

namespace pbrt {
namespace {

/// A named material knows those defined before it, an unnamed one all.
MaterialId AddMaterial(const Entity &entity, const Description &scene,
                       const NamedTextures &textures, const NamedMaterials &named, World &world,
                       Diagnostics &log) {
    if (entity.type == InterfaceMaterial::kName) return kInterfaceId;
    ParamDict params(entity.params, entity.loc, fmt::format("material \"{}\"", entity.type),
                     entity.colorSpace, &log, scene.dir);
    if (entity.type == MixMaterial::kName) {
        world.mixes.push_back(MixMaterial::Create(params, textures, named));
        params.ReportUnused();
        return kFirstMix + int(world.mixes.size()) - 1;
    }
    std::optional<Material> material = CreateMaterial(entity.type, params, textures);
    if (!material) return kMissingMaterialId;
    world.materials.push_back(std::move(*material));
    return int(world.materials.size()) - 1;
}

/// Finds directives that say the same: many scenes give every shape a material of its own, and few
/// different ones.
class EqualMaterials {
  public:
    /// All but the places.
    std::string ContentOf(Entity entity) {
        entity.loc = {};
        for (ParsedParameter &p : entity.params)
            p.loc = p.valueLoc = {};
        std::string content;
        packer.Write(entity, &content);
        return content;
    }
    std::optional<MaterialId> Find(const std::string &content) const {
        const auto found = made.find(content);
        if (found == made.end()) return {};
        return found->second;
    }
    void Note(std::string content, MaterialId id) { made.emplace(std::move(content), id); }

  private:
    EntityPacker packer;
    std::unordered_map<std::string, MaterialId> made;
};

}  // namespace

MaterialTable BuildMaterials(Description &scene, const NamedTextures &textures, World &world,
                             Diagnostics &log) {
    MaterialTable table;
    // Growing, they would be there twice; room that is not used costs no memory.
    world.materials.reserve(1 + scene.namedMaterials.size() + scene.materials.size());
    world.materials.push_back(DiffuseMaterial{});
    for (const NamedMaterialEntity &entity : scene.namedMaterials)
        table.named[entity.name] = AddMaterial(entity, scene, textures, table.named, world, log);
    EqualMaterials equals;
    while (!scene.materials.empty()) {
        const Entity &entity = scene.materials.Take();
        const std::string content = equals.ContentOf(entity);
        if (const std::optional<MaterialId> known = equals.Find(content)) {
            table.unnamed.push_back(*known);
            continue;
        }
        const size_t messages = log.Messages().size();
        table.unnamed.push_back(AddMaterial(entity, scene, textures, table.named, world, log));
        if (log.Messages().size() == messages) equals.Note(content, table.unnamed.back());
    }
    return table;
}

}  // namespace pbrt
