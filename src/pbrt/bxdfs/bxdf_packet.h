#pragma once

#include <array>
#include <optional>

#include "pbrt/base/bxdf.h"

namespace pbrt {

/// Any sixteen BxDFs of a type, one by one.
template <BxDFType BxDF>
class OneByOnePacket {
  public:
    void Set(int i, const BxDF &bxdf) { lanes[size_t(i)].emplace(bxdf); }
    void Regularize(int i) { pbrt::Regularize(*lanes[size_t(i)]); }
    BxDFFlags Flags(int i) const { return lanes[size_t(i)]->Flags(); }

    BxDFValues Evaluate(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active) const {
        BxDFValues values;
        ForEachLane(active, [&](int i) {
            const BSDFEval both = pbrt::Evaluate(*lanes[size_t(i)], Lane(wo, i), Lane(wi, i),
                                                 TransportMode::Radiance);
            values.f[size_t(i)] = both.f;
            values.pdf.Set(i, both.pdf);
        });
        return values;
    }

    BxDFSamples Sample(const Vector3fX16 &wo, const FloatX16 &uc, const Point2fX16 &u,
                       LaneBits active) const {
        BxDFSamples samples;
        ForEachLane(active, [&](int i) {
            const auto s =
                lanes[size_t(i)]->Sample_f(Lane(wo, i), uc[i], Lane(u, i), TransportMode::Radiance);
            if (!s) return;
            samples.f[size_t(i)] = s->f;
            SetLane(&samples.wi, i, s->wi);
            samples.pdf.Set(i, s->pdf);
            samples.eta.Set(i, s->eta);
            samples.valid |= LaneBits(1) << i;
            samples.specular |= LaneBits(IsSpecular(s->flags)) << i;
            samples.nullTransmission |= LaneBits(Has(s->flags, BxDFFlags::NullTransmission)) << i;
            samples.transmission |= LaneBits(Has(s->flags, BxDFFlags::Transmission)) << i;
        });
        return samples;
    }

  private:
    std::array<std::optional<BxDF>, kPacketSize> lanes;
};

namespace detail {
template <BxDFType B>
struct PacketOf {
    using Packet = OneByOnePacket<B>;
    using Input = B;
};
template <BxDFType B>
requires(B::kTraits.hasPacket) struct PacketOf<B> {
    using Packet = typename B::Packet;
    using Input = typename B::PacketInput;
};
}  // namespace detail

/// Sixteen BxDFs of type B, as a BxDFPacketType: B's own packet, or one by one. Where B announces a
/// packet whose header is not included, the type is incomplete and the program does not compile.
template <BxDFType B>
using BxDFPacket = typename detail::PacketOf<B>::Packet;
/// Input for one lane of BxDFPacket<B>; B itself unless it has a packet of its own.
template <BxDFType B>
using BxDFPacketInput = typename detail::PacketOf<B>::Input;

}  // namespace pbrt
