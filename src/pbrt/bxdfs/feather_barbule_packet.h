#pragma once

#include <array>
#include <optional>

#include "pbrt/base/bxdf.h"
#include "pbrt/bxdfs/feather_barbule_bxdf.h"

namespace pbrt {

/// Sixteen of FeatherBarbuleBxDF, in half of the time or less.
class FeatherBarbulePacket {
  public:
    void Set(int i, const FeatherSurface &surface);
    void Regularize(int) {}
    BxDFFlags Flags(int) const { return FeatherBarbuleBxDF::kFlags; }

    using Spectra = std::array<SampledSpectrum, kPacketSize>;
    Spectra f(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active);
    /// The two terms of f by themselves.
    struct LobeValues {
        Spectra R, TRT;
    };
    LobeValues Lobes(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active);
    FloatX16 PDF(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active);
    BxDFValues Evaluate(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active);

    /// Sample, but for f, which is only set where light passes a gap.
    BxDFSamples Draw(const Vector3fX16 &wo, const FloatX16 &uc, const Point2fX16 &u,
                     LaneBits active);
    BxDFSamples Sample(const Vector3fX16 &wo, const FloatX16 &uc, const Point2fX16 &u,
                       LaneBits active);

  private:
    using V = FloatX16;
    using Model = feather::Barbule<V, NSpectrumSamples>;

    const Model &Barbules();
    BxDFSamples Draw(const feather::View<V> &view, const Vector3fX16 &wo, const FloatX16 &uc,
                     const Point2fX16 &u, LaneBits active);

    // Lanes that are never set stay 0: what comes of them is not used.
    feather::Vane<V> vane{};
    V tilt{}, thickness{}, roughness{};
    LaneBits tilted = 0;  ///< lanes of other than the vane's tilt
    feather::Optics<V, NSpectrumSamples> optics{};
    std::optional<Model> barbules;
};
static_assert(BxDFPacketType<FeatherBarbulePacket, FeatherSurface>);

}  // namespace pbrt
