#pragma once

#include <array>
#include <map>

#include "pbrt/materials/bounded_texture.h"
#include "pbrt/util/hash.h"

namespace pbrt {

/// Number of a scene's material: below kFirstMix an index into RenderScene::materials, else a mix.
using MaterialId = int;
inline constexpr MaterialId kFirstMix = 1 << 30;
inline constexpr MaterialId kInterfaceId = -1;        ///< does not scatter
inline constexpr MaterialId kMissingMaterialId = -2;  ///< after an error, which is in the log
using NamedMaterials = std::map<std::string, MaterialId>;

/// Two materials strewn over one surface: each ray meets one of them, `amount` being the share of
/// the second. Either may be a mix again.
struct MixMaterial {
    static constexpr std::string_view kName = "mix";
    std::array<MaterialId, 2> materials{};
    BoundedTexture amount;

    /// `named`: materials that it can be made of.
    static MixMaterial Create(ParamDict &params, const NamedTextures &textures,
                              const NamedMaterials &named);
    /// Material that a ray of direction `d` meets: chosen by chance, but for the same point and
    /// direction always the same. `index` tells the scene's mixes apart.
    MaterialId Choose(const TextureEvalContext &ctx, Vector3f d, MaterialId index) const {
        const float share = amount.Evaluate(ctx);
        if (share <= 0) return materials[0];
        if (share >= 1) return materials[1];
        return HashFloat(ctx.p, d, index) < share ? materials[1] : materials[0];
    }
    /// A sentence where texture values had to be clamped; else empty.
    std::string Warnings(const ClampCounts &counts) const;
};

}  // namespace pbrt
