#pragma once

#include <memory>

#include "pbrt/base/surface_interaction.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// Small relief of a surface that only its shading shows: shading normals are tilted by a height
/// texture (`displacement`, in rendering-space lengths along the normal) or taken from an image of
/// normals (`normalmap`), which counts where both are given. Immutable.
class BumpMap {
  public:
    /// Null where the parameters give no relief. After an error, which is reported through params,
    /// null or any relief.
    static std::shared_ptr<const BumpMap> Create(ParamDict &params, const NamedTextures &named);

    /// Reads what fibres accept of it, which has no effect: pbrt-v4's hair ignores a `normalmap`,
    /// and knows no `displacement`.
    static void Ignore(ParamDict &params);

    /// Sets sp's ns, and under a height dpdus, to those of the relief. `ctx`: that of sp. ns stays
    /// unit and in n's hemisphere; both stay as they are where the relief has no normal, as where
    /// uv have no derivatives or the texture is not finite.
    void Tilt(const TextureEvalContext &ctx, SurfaceInteraction *sp) const;
    /// True where the surface's uv are looked at beyond what the texture does.
    bool ReadsUV() const { return normals != nullptr; }

  private:
    /// The relief's normal, of any length, in the shading frame's hemisphere or not.
    Vector3f FromNormalMap(const TextureEvalContext &ctx, const SurfaceInteraction &sp) const;
    void TiltByHeight(const TextureEvalContext &ctx, SurfaceInteraction *sp) const;

    FloatTexture height;
    std::shared_ptr<const MIPMap> normals;  ///< null: height counts
};

}  // namespace pbrt
