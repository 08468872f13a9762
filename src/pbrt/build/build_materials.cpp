#include <fmt/format.h>

#include <map>

#include "pbrt/build/build_shapes.h"
#include "pbrt/materials/materials.h"
#include "pbrt/scene/content_hash.h"

namespace pbrt {
namespace {

/// Makes materials and notes what of them goes by uv.
class MaterialMaker {
  public:
    MaterialMaker(const SceneDescription &description, const NamedTextures &textures,
                  RenderScene &scene, MaterialTable &table, Diagnostics &log)
        : description(description), textures(textures), scene(scene), table(table), log(log) {}

    /// A named material knows those defined before it, an unnamed one all.
    MaterialId Add(const Entity &entity) {
        if (entity.type == InterfaceMaterial::kName) return kInterfaceId;
        ParamDict params(entity.params, entity.loc, fmt::format("material \"{}\"", entity.type),
                         entity.colorSpace, &log, description.dir);
        const MaterialId id =
            entity.type == MixMaterial::kName ? AddMix(params) : AddSingle(entity.type, params);
        if (textures.AnyReadsUV(entity.params)) table.texturedByUV.insert(id);
        return id;
    }

  private:
    MaterialId AddMix(ParamDict &params) {
        const MaterialId id = kFirstMix + int(scene.mixes.size());
        scene.mixes.push_back(MixMaterial::Create(params, textures, table.named));
        params.ReportUnused();
        int parts = 0;
        for (const MaterialId part : scene.mixes.back().materials)
            parts += part >= kFirstMix ? partsOf[size_t(part - kFirstMix)] : 1;
        if (parts > kMostParts) {
            params.Error(fmt::format("mixes of mixes make {} materials of this one, more than {}",
                                     parts, kMostParts));
            scene.mixes.back().materials = {0, 0};
            parts = 2;
        }
        partsOf.push_back(parts);
        for (const MaterialId part : scene.mixes.back().materials) {
            if (const auto laid = table.laidByUV.find(part); laid != table.laidByUV.end())
                table.laidByUV.emplace(id, laid->second);
            if (table.texturedByUV.contains(part)) table.texturedByUV.insert(id);
        }
        return id;
    }
    MaterialId AddSingle(std::string_view type, ParamDict &params) {
        std::optional<Material> material = CreateMaterial(type, params, textures);
        if (!material) return kMissingMaterialId;
        const MaterialId id = scene.materials.Add(std::move(*material));
        if (scene.materials.BumpReadsUV(size_t(id))) table.texturedByUV.insert(id);
        if (const std::string_view laid = scene.materials.LaidByUV(size_t(id)); !laid.empty())
            table.laidByUV.emplace(id, laid);
        return id;
    }

    /// Every part may be asked for each ray, as for gaps.
    static constexpr int kMostParts = 1000;

    const SceneDescription &description;
    const NamedTextures &textures;
    RenderScene &scene;
    MaterialTable &table;
    Diagnostics &log;
    std::vector<int> partsOf;  ///< by mix: single materials in it, repeated ones counted
};

}  // namespace

MaterialTable BuildMaterials(SceneDescription &description, const NamedTextures &textures,
                             RenderScene &scene, Diagnostics &log) {
    MaterialTable table;
    MaterialMaker maker(description, textures, scene, table, log);
    // Reserved up front: growing would hold two copies, and untouched memory costs nothing.
    scene.materials.Reserve(1 + description.namedMaterials.size() + description.materials.size());
    scene.materials.Add(DiffuseMaterial{});
    for (const NamedMaterialEntity &entity : description.namedMaterials)
        table.named[entity.name] = maker.Add(entity);
    // Many scenes give every shape a material of its own, and few different ones.
    std::map<ContentHash, MaterialId> made;
    while (!description.materials.empty()) {
        const Entity &entity = description.materials.Take();
        const ContentHash content = HashContent(entity);
        if (const auto known = made.find(content); known != made.end()) {
            table.unnamed.push_back(known->second);
            continue;
        }
        const size_t messages = log.Messages().size();
        table.unnamed.push_back(maker.Add(entity));
        // One that gave a message is made again where it is repeated, for the message's place.
        if (log.Messages().size() == messages) made.emplace(content, table.unnamed.back());
    }
    return table;
}

}  // namespace pbrt
