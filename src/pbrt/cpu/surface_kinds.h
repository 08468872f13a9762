#pragma once

#include "pbrt/cpu/world.h"

namespace pbrt {

/// Sorts what paths meet by the code that handles it: by the type of the material, and what can be
/// shaded sixteen at a time apart.
class SurfaceKinds {
  public:
    static constexpr int kNone = 0;  ///< the ray left the scene
    static constexpr int kFirstType = 1;
    static constexpr int kMix = kFirstType + int(std::variant_size_v<Material>);
    static constexpr int kWideDiffuse = kMix + 1;
    static constexpr int kMost = kMix + 2;

    explicit SurfaceKinds(const World &world) {
        const uint32_t nTop = world.TopLevelGeometries();
        for (uint32_t i = 0; i < world.geometries.size(); ++i)
            of.push_back(uint8_t(KindOf(world, world.geometries[i], i >= nTop)));
    }
    int Of(uint32_t geometry) const { return of[geometry]; }

  private:
    static int KindOf(const World &world, const Geometry &g, bool instanced) {
        if (world.AsMix(g.material)) return kMix;
        const Material &material = world.materials[size_t(g.material)];
        const auto *diffuse = std::get_if<DiffuseMaterial>(&material);
        if (!instanced && diffuse && diffuse->reflectance.IsConstant()) return kWideDiffuse;
        return kFirstType + int(material.index());
    }
    std::vector<uint8_t> of;  ///< by geometry
};

}  // namespace pbrt
