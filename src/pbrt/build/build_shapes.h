#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/build/places.h"
#include "pbrt/build/render_scene.h"

namespace pbrt {

/// The description's materials, in its order.
struct MaterialTable {
    std::vector<MaterialId> unnamed;
    NamedMaterials named;
    MaterialId fallback = 0;                          ///< the default material, diffuse 0.5
    std::map<MaterialId, std::string_view> laidByUV;  ///< MaterialSet::LaidByUV, where not empty
    std::set<MaterialId> texturedByUV;                ///< some texture looks at the surface's uv
};
/// Takes the unnamed ones out of the description; of those that say the same, one is made.
MaterialTable BuildMaterials(SceneDescription &description, const NamedTextures &textures,
                             RenderScene &scene, Diagnostics &log);

/// Reads `alpha`, which every shape has.
FloatTexture GetAlpha(ParamDict &params, const NamedTextures &textures);

struct EmissiveShape {
    uint32_t geometry;
    std::shared_ptr<const Entity> areaLight;
    int instance = -1;  ///< that carries it; -1: at rest
};
struct BuiltShapes {
    std::vector<EmissiveShape> emitters;
    Places instances;  ///< of RenderScene::instances, one each
};
/// Fills RenderScene::geometries (those of the top level first), objects and instances; nested
/// instances are flattened, since the ray tracer nests them one deep only. Takes the shapes out of
/// the description.
BuiltShapes BuildShapes(SceneDescription &description, const NamedTextures &textures,
                        const MaterialTable &materials, RenderScene &scene, Diagnostics &log);

}  // namespace pbrt
