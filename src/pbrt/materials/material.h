#pragma once

#include <optional>

#include "pbrt/materials/coated_diffuse.h"
#include "pbrt/materials/conductor.h"
#include "pbrt/materials/dielectric.h"
#include "pbrt/materials/diffuse.h"
#include "pbrt/materials/diffuse_transmission.h"
#include "pbrt/materials/feather_barbule.h"
#include "pbrt/materials/hair.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// No scattering: light passes as if nothing were there. Its shapes are not traced at all.
struct InterfaceMaterial {
    static constexpr std::string_view kName = "interface";
};

/// The one list of materials that scatter. A mix chooses one of them first. CONTRIBUTING.md has the
/// members that each must have, and those it may have.
using MaterialTypes =
    TypeList<DiffuseMaterial, ConductorMaterial, DielectricMaterial, FeatherBarbuleMaterial,
             HairMaterial, DiffuseTransmissionMaterial, CoatedDiffuseMaterial>;
using Material = MaterialTypes::Variant;

/// Surfaces that let shadow rays through declare kHasNullTransmission.
template <typename M>
inline constexpr bool HasNullTransmissionV = requires {
    M::kHasNullTransmission;
};
inline bool HasNullTransmission(const Material &material) {
    return std::visit([]<typename M>(const M &) { return HasNullTransmissionV<M>; }, material);
}

/// Materials whose BxDFs have but one lobe, so that Sample_f reads no uc, declare kOneLobe.
template <typename M>
inline constexpr bool HasOneLobe = requires {
    M::kOneLobe;
};

/// Materials whose frame turns about the normal, so that they need tangents always.
template <typename M>
inline constexpr bool TurnsFrame = requires(const M &m, const TextureEvalContext &ctx) {
    m.TurnFrame(Frame(), ctx);
};

/// Materials that stand for a fibre, met at an offset along the frame's y, declare kFibre: their
/// frame faces the viewer.
template <typename M>
inline constexpr bool IsFibre = requires {
    M::kFibre;
};

/// Whether the material is the same at every point, so that it needs no uv, nor tangents, where it
/// does not turn its frame. Types that can be so have a member of that name.
inline bool IsUniform(const Material &material) {
    return std::visit(
        [](const auto &m) {
            if constexpr (requires { m.IsUniform(); })
                return m.IsUniform();
            else
                return false;
        },
        material);
}

/// What runs along dp/du or dp/dv, in the plural, as "barbules"; empty where nothing does. Types
/// where something does so have a member of that name. Textures are not meant.
inline std::string_view LaidByUV(const Material &material) {
    return std::visit(
        [](const auto &m) -> std::string_view {
            if constexpr (requires { m.LaidByUV(); })
                return m.LaidByUV();
            else if constexpr (requires { m.roughness.LaidByUV(); })
                return m.roughness.LaidByUV();
            else
                return {};
        },
        material);
}

/// What a material noticed while rendering, as a sentence; else empty.
inline std::string Warnings(const Material &material) {
    return std::visit(
        [](const auto &m) -> std::string {
            if constexpr (requires { m.Warnings(); })
                return m.Warnings();
            else
                return {};
        },
        material);
}

/// An error at the directive, with the list of materials, where `type` is none of them.
std::optional<Material> CreateMaterial(std::string_view type, ParamDict &params,
                                       const NamedTextures &named);
/// Names for messages: all of MaterialTypes, mix and interface.
std::vector<std::string_view> MaterialNames();

}  // namespace pbrt
