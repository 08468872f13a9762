#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/base/material.h"

namespace pbrt {

class Material;  // one of the types listed in materials.h

/// Properties of a material that are known without its type.
struct MaterialFacts {
    uint8_t type;           ///< place in MaterialTypes
    bool isUniform;         ///< the same at every point, without relief; see
                            ///< MaterialTraits::canBeUniform
    bool nullTransmission;  ///< see MaterialTraits::nullTransmission
};

/// The materials of a scene that scatter, numbered from 0.
class MaterialSet {
  public:
    MaterialSet();
    MaterialSet(MaterialSet &&) noexcept;
    MaterialSet &operator=(MaterialSet &&) noexcept;
    ~MaterialSet();

    void Reserve(size_t count);
    /// The number of the added material.
    int Add(Material material);
    size_t Size() const { return facts.size(); }
    const MaterialFacts &Facts(size_t i) const { return facts[i]; }
    /// All of them, one after another; use needs materials.h.
    const Material *Data() const { return materials.data(); }
    /// True where any has a BumpMap.
    bool AnyBump() const { return anyBump; }
    /// True where its BumpMap looks at the surface's uv.
    bool BumpReadsUV(size_t i) const;
    /// See MaterialTraits::laidByUV; empty where nothing is.
    std::string_view LaidByUV(size_t i) const;
    /// Warnings of the materials after rendering, one sentence for each that has any.
    std::vector<std::string> Warnings(const ClampCounts &counts) const;

  private:
    std::vector<Material> materials;
    std::vector<MaterialFacts> facts;
    bool anyBump = false;
};

}  // namespace pbrt
