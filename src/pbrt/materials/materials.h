#pragma once

#include <optional>

#include "pbrt/bxdfs/bxdf_packet.h"
#include "pbrt/materials/bump_map.h"
#include "pbrt/materials/coated_conductor.h"
#include "pbrt/materials/coated_diffuse.h"
#include "pbrt/materials/conductor.h"
#include "pbrt/materials/dielectric.h"
#include "pbrt/materials/diffuse.h"
#include "pbrt/materials/diffuse_transmission.h"
#include "pbrt/materials/feather_barbule.h"
#include "pbrt/materials/hair.h"
#include "pbrt/materials/thin_dielectric.h"
#include "pbrt/util/type_list.h"

// Who includes this compiles anew whenever a material is added. What can be said of a material
// without its type is in material_set.h.

namespace pbrt {

/// No scattering: light passes as if nothing were there. Its shapes are not traced at all.
struct InterfaceMaterial {
    static constexpr std::string_view kName = "interface";
};

/// The one list of materials that scatter; a mix chooses one of them first. Parser, messages,
/// renderer, bsdftool and the tests follow from it. At most 127 types.
using MaterialTypes =
    TypeList<DiffuseMaterial, ConductorMaterial, DielectricMaterial, FeatherBarbuleMaterial,
             HairMaterial, DiffuseTransmissionMaterial, CoatedDiffuseMaterial,
             ThinDielectricMaterial, CoatedConductorMaterial>;

/// One of MaterialTypes. A class, so that others can name it without the list.
class Material : public MaterialTypes::Variant {
  public:
    using MaterialTypes::Variant::Variant;

    /// Tilts the shading frame before the material is asked for anything; null: nothing does.
    std::shared_ptr<const BumpMap> bump;
};

template <MaterialType M>
inline constexpr bool kIsMaterial =
    BxDFPacketType<BxDFPacket<BxDFOf<M>>, BxDFPacketInput<BxDFOf<M>>>;
static_assert(MaterialTypes::All([]<typename M>() { return kIsMaterial<M>; }));

/// Input for one lane of a BxDFPacket: the BxDF, or the data that stand for it.
template <MaterialType M>
BxDFPacketInput<BxDFOf<M>> PacketInputAt(const M &material, const TextureEvalContext &ctx,
                                         SampledWavelengths &lambda) {
    if constexpr (detail::kHasOwnPacketInput<BxDFOf<M>>)
        return material.GetPacketInput(ctx, lambda);
    else
        return material.GetBxDF(ctx, lambda);
}

/// An error at the directive, with the list of materials, where `type` is none of them.
std::optional<Material> CreateMaterial(std::string_view type, ParamDict &params,
                                       const NamedTextures &named);
/// Names for messages: all of MaterialTypes, mix and interface.
std::vector<std::string_view> MaterialNames();

}  // namespace pbrt
