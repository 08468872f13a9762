#pragma once

#include "pbrt/materials/materials.h"
#include "textures/texture_scene.h"

namespace pbrt::test {

/// The last unnamed material of a piece of scene text, made as the renderer makes it.
struct MaterialText : TextureScene {
    explicit MaterialText(const std::string &world) : TextureScene(world) {
        Entity entity;
        for (const Entity &e : scene.materials)
            entity = e;
        ParamDict params(entity.params, entity.loc, "material \"" + entity.type + "\"",
                         entity.colorSpace, &log, scene.dir);
        material = CreateMaterial(entity.type, params, named);
    }
    template <typename M>
    const M &As() const {
        EXPECT_FALSE(log.HasErrors()) << Messages();
        return std::get<M>(*material);
    }

    std::optional<Material> material;
};

}  // namespace pbrt::test
