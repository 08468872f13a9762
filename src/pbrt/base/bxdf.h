#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>

#include "pbrt/base/plug_in.h"
#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/vecmath.h"
#include "pbrt/util/vecmath_simd.h"

// The contract of a BxDF: the scattering of light at a point of a surface, in the local frame
// there. Implementations are in pbrt/bxdfs/<name>_bxdf.h; the BxDFs that exist are those of the
// materials of pbrt/materials/materials.h, for there is no other way to one.

namespace pbrt {

enum class TransportMode : uint8_t { Radiance, Importance };

enum class BxDFFlags : uint8_t {
    Unset = 0,
    Reflection = 1,
    Transmission = 2,
    Diffuse = 4,
    Glossy = 8,
    Specular = 16,
    /// Straight through (wi = -wo): no refraction, no bounce; the path keeps its MIS state.
    NullTransmission = 32,
};
constexpr BxDFFlags operator|(BxDFFlags a, BxDFFlags b) {
    return BxDFFlags(uint8_t(a) | uint8_t(b));
}
constexpr bool Has(BxDFFlags flags, BxDFFlags bits) {
    return (uint8_t(flags) & uint8_t(bits)) != 0;
}
constexpr bool IsReflective(BxDFFlags f) {
    return Has(f, BxDFFlags::Reflection);
}
constexpr bool IsTransmissive(BxDFFlags f) {
    return Has(f, BxDFFlags::Transmission);
}
constexpr bool IsSpecular(BxDFFlags f) {
    return Has(f, BxDFFlags::Specular);
}
constexpr bool IsNonSpecular(BxDFFlags f) {
    return Has(f, BxDFFlags::Diffuse | BxDFFlags::Glossy);
}

struct BSDFSample {
    SampledSpectrum f;  ///< 1/sr without cosine; for delta lobes F/|cos|
    Vector3f wi;
    float pdf;  ///< 1/sr; for delta lobes the lobe's probability
    BxDFFlags flags;
    float eta = 1;  ///< relative index of refraction where the sample refracts
};

/// f and PDF for the same directions.
struct BSDFEval {
    SampledSpectrum f;
    float pdf;
};

/// f and PDF of sixteen pairs of directions.
struct BxDFValues {
    std::array<SampledSpectrum, kPacketSize> f;
    FloatX16 pdf{};
};

/// Sixteen of BSDFSample; only the `valid` lanes mean something.
struct BxDFSamples {
    std::array<SampledSpectrum, kPacketSize> f;
    Vector3fX16 wi{};
    FloatX16 pdf{};
    FloatX16 eta = Broadcast<16>(1.f);
    LaneBits valid = 0, specular = 0, nullTransmission = 0, transmission = 0;
};

/// Members that a BxDF may have beyond the compulsory ones; each must be announced here, so that a
/// misspelt or forgotten one is an error where the BxDF is defined.
struct BxDFTraits {
    /// Has `void Regularize()`: blurs lobes sharper than alpha 0.3 (TrowbridgeReitz), for the
    /// integrator's "regularize". Without it the lobes stay as they are, which is right where they
    /// are never so sharp.
    bool regularizes = false;
    /// Has `BSDFEval Evaluate(Vector3f wo, Vector3f wi, TransportMode) const`: f and PDF of the
    /// same directions. Without it they are called one after the other, and what they share is
    /// worked out twice.
    bool evaluatesTogether = false;
    /// Has its own `Packet`, a BxDFPacketType, and `PacketInput`, what a lane of it is made of:
    /// sixteen of this BxDF at once. Without it sixteen are evaluated one by one; diffuse's packet
    /// takes 10 to 20 % off the time of a scene of diffuse surfaces, the feather's takes half of
    /// the time of one by one or less.
    bool hasPacket = false;
};

namespace detail {
template <typename B>
concept HasRegularize = requires(B b) {
    { b.Regularize() } -> std::same_as<void>;
};
template <typename B>
concept HasEvaluate = requires(const B b, Vector3f w, TransportMode mode) {
    { b.Evaluate(w, w, mode) } -> std::same_as<BSDFEval>;
};
template <typename B>
concept HasPacket = requires {
    typename B::Packet;
    typename B::PacketInput;
};
}  // namespace detail

/// A copyable value that lives in the local frame: z is the shading normal, x lies along dp/du
/// (unless the material says otherwise: MaterialTraits). Directions are unit and point away from
/// the surface; wo is the given one, wi the one asked for. All functions are functions of their
/// arguments alone: chance comes in through uc in [0, 1) and u in [0, 1)^2.
///
///   kTraits    BxDFTraits; all false is a valid choice
///   Flags()    all lobes that there may be; Unset where nothing scatters
///   f          BSDF without the cosine, 1/sr, >= 0 and finite; 0 for delta lobes. Where light is
///              refracted, radiance is scaled by (incident / transmitted index)^2, importance not
///   PDF        density with which Sample_f draws wi, 1/sr; without delta lobes, so its integral
///              over the sphere is at most 1
///   Sample_f   a direction and BSDFSample::f and pdf of it, which agree with f and PDF but for
///              delta lobes; nullopt where nothing scatters. uc chooses the lobe, u the direction
///
/// The laws that each BxDF is tested on are in test/bxdf/laws_test.cpp: energy, reciprocity,
/// normalisation, agreement of sampling and density, finite values, same bits for same arguments.
template <typename B>
concept BxDFType = std::copy_constructible<B> &&
    requires(const B b, Vector3f w, float u, Point2f u2, TransportMode mode) {
    { B::kTraits } -> std::same_as<const BxDFTraits &>;
    { b.Flags() } -> std::same_as<BxDFFlags>;
    { b.f(w, w, mode) } -> std::same_as<SampledSpectrum>;
    { b.PDF(w, w, mode) } -> std::same_as<float>;
    { b.Sample_f(w, u, u2, mode) } -> std::same_as<std::optional<BSDFSample>>;
} && detail::AsAnnounced<B::kTraits.regularizes, detail::HasRegularize<B>> &&
    detail::AsAnnounced<B::kTraits.evaluatesTogether, detail::HasEvaluate<B>> &&
    detail::AsAnnounced<B::kTraits.hasPacket, detail::HasPacket<B>>;

/// Sixteen BxDFs side by side, made of `Input`s; see bxdfs/bxdf_packet.h for the general one.
///   Set(i, input)      lane i; lanes never set are never `active`
///   Regularize(i)      BxDFTraits::regularizes of lane i; does nothing where that is false
///   Flags(i)           as the BxDF's
///   Evaluate, Sample   f and PDF, Sample_f, of the `active` lanes, for radiance: equal to the
///                      BxDF's but for rounding. May keep intermediate results, so not const
template <typename P, typename Input>
concept BxDFPacketType = requires(P p, int i, const Input &input, const Vector3fX16 &w,
                                  const FloatX16 &uc, const Point2fX16 &u, LaneBits active) {
    p.Set(i, input);
    p.Regularize(i);
    { p.Flags(i) } -> std::same_as<BxDFFlags>;
    { p.Evaluate(w, w, active) } -> std::same_as<BxDFValues>;
    { p.Sample(w, uc, u, active) } -> std::same_as<BxDFSamples>;
};

/// Blurs lobes that are sharp, if B ever has such.
template <BxDFType B>
void Regularize(B &bxdf) {
    if constexpr (B::kTraits.regularizes) bxdf.Regularize();
}

/// f and PDF together.
template <BxDFType B>
BSDFEval Evaluate(const B &bxdf, Vector3f wo, Vector3f wi, TransportMode mode) {
    if constexpr (B::kTraits.evaluatesTogether)
        return bxdf.Evaluate(wo, wi, mode);
    else
        return {bxdf.f(wo, wi, mode), bxdf.PDF(wo, wi, mode)};
}

}  // namespace pbrt
