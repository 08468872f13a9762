#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "pbrt/base/bxdf.h"
#include "pbrt/base/plug_in.h"
#include "pbrt/base/texture.h"

// The contract of a material: which BxDF a surface has at each of its points. The closed list of
// materials is in pbrt/materials/materials.h.

namespace pbrt {

class ParamDict;
struct NamedTextures;

/// Promises of a material type, and its members beyond the compulsory ones. Each must be
/// announced here, so that a misspelt or forgotten one is an error where the material is listed.
/// A material that promises nothing is rendered correctly.
struct MaterialTraits {
    /// GetBxDF takes `SampledWavelengths &` and may end the path's secondary wavelengths, as where
    /// the index of refraction depends on the wavelength. Others take `const &`: nobody else may
    /// write them.
    bool terminatesWavelengths = false;
    /// Sample_f of the BxDF reads no uc. Saves a random number at each vertex.
    bool oneLobe = false;
    /// Any frame about the normal will do. Saves the frame along dp/du at each vertex.
    bool isotropic = false;
    /// The surface stands for a fibre that is met at an offset along the frame's y: the frame's z
    /// faces the viewer, its x lies along dp/du.
    bool fibre = false;
    /// Has `bool IsUniform() const`: true where GetBxDF reads nothing of its context. Then uv, and
    /// unless turnsFrame tangents, are not worked out; x lies anywhere about the normal. Without it
    /// they are worked out at each vertex.
    bool canBeUniform = false;
    /// Has `Frame TurnFrame(const Frame &, const TextureEvalContext &) const`, the frame turned
    /// as its axes lie there, and `bool TurnsFrame() const`, false where it never is.
    bool turnsFrame = false;
    /// Has `float NullTransmission(const TextureEvalContext &, Vector3f w) const`: the share, in
    /// [0, 1], of light from direction w (local, in the turned frame) that passes straight through.
    /// It equals the probability with which Sample_f gives NullTransmission. Shadow rays go on with
    /// that share; without it they end at the surface.
    bool nullTransmission = false;
    /// Has `std::string_view LaidByUV() const`: what runs along dp/du or dp/dv, in the plural, as
    /// "barbules"; empty where nothing does. Textures are not meant. With it a mesh without uv gets
    /// a warning that names it.
    bool laidByUV = false;
    /// Has `std::string Warnings(const ClampCounts &) const`: after rendering, a sentence about
    /// values out of range that were met (see BoundedTexture), else empty. Without it they go
    /// unnoticed.
    bool warns = false;
};

/// The BxDF that a material makes.
template <typename M>
using BxDFOf = decltype(std::declval<const M &>().GetBxDF(
    std::declval<const TextureEvalContext &>(), std::declval<SampledWavelengths &>()));

namespace detail {
template <typename M>
concept GetBxDFReadsWavelengths = requires(const M m, const TextureEvalContext &ctx,
                                           const SampledWavelengths &lambda) {
    m.GetBxDF(ctx, lambda);
};
template <typename M>
concept HasIsUniform = requires(const M m) {
    { m.IsUniform() } -> std::same_as<bool>;
};
template <typename M>
concept HasTurnFrame = requires(const M m, const Frame &frame, const TextureEvalContext &ctx) {
    { m.TurnFrame(frame, ctx) } -> std::same_as<Frame>;
    { m.TurnsFrame() } -> std::same_as<bool>;
};
template <typename M>
concept HasNullTransmission = requires(const M m, const TextureEvalContext &ctx, Vector3f w) {
    { m.NullTransmission(ctx, w) } -> std::same_as<float>;
};
template <typename M>
concept HasLaidByUV = requires(const M m) {
    { m.LaidByUV() } -> std::same_as<std::string_view>;
};
template <typename M>
concept HasWarnings = requires(const M m, const ClampCounts &counts) {
    { m.Warnings(counts) } -> std::same_as<std::string>;
};
template <typename M>
concept HasPacketInput = requires(const M m, const TextureEvalContext &ctx,
                                  const SampledWavelengths &lambda) {
    { m.GetPacketInput(ctx, lambda) } -> std::same_as<typename BxDFOf<M>::PacketInput>;
};
/// The BxDF's packet is made of something that is not the BxDF.
template <typename B>
inline constexpr bool kHasOwnPacketInput = false;
template <BxDFType B>
requires(B::kTraits.hasPacket) inline constexpr bool kHasOwnPacketInput<B> =
    !std::same_as<typename B::PacketInput, B>;
}  // namespace detail

/// Copyable and immutable once made; any thread may read it.
///
///   kTraits               MaterialTraits
///   Create(params, named) reads all parameters; mistakes are reported through params, and the
///                         material is usable all the same
///   GetBxDF(ctx, lambda)  the BxDF at a point, at these wavelengths, in the frame that the traits
///                         ask for. A function of its arguments. Only terminatesWavelengths may
///                         write lambda. The BxDF may point into the material, not into ctx
///   GetPacketInput(ctx, lambda)   only where the BxDF's PacketInput is another type than the BxDF:
///                         what its packet is made of in place of GetBxDF
template <typename M>
concept MaterialType = PlugInType<M> && std::copy_constructible<M> &&
    requires(const M m, ParamDict &params, const NamedTextures &named,
             const TextureEvalContext &ctx, SampledWavelengths &lambda) {
    { M::kTraits } -> std::same_as<const MaterialTraits &>;
    { M::Create(params, named) } -> std::same_as<M>;
    { m.GetBxDF(ctx, lambda) } -> BxDFType;
} && detail::AsAnnounced<M::kTraits.terminatesWavelengths, !detail::GetBxDFReadsWavelengths<M>> &&
    detail::AsAnnounced<M::kTraits.canBeUniform, detail::HasIsUniform<M>> &&
    detail::AsAnnounced<M::kTraits.turnsFrame, detail::HasTurnFrame<M>> &&
    detail::AsAnnounced<M::kTraits.nullTransmission, detail::HasNullTransmission<M>> &&
    detail::AsAnnounced<M::kTraits.laidByUV, detail::HasLaidByUV<M>> &&
    detail::AsAnnounced<M::kTraits.warns, detail::HasWarnings<M>> &&
    detail::AsAnnounced<detail::kHasOwnPacketInput<BxDFOf<M>>, detail::HasPacketInput<M>>;

}  // namespace pbrt
