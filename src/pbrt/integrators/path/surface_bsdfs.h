#pragma once

#include <algorithm>

#include "pbrt/bxdfs/albedo.h"
#include "pbrt/bxdfs/bxdf_packet.h"
#include "pbrt/bxdfs/diffuse_bxdf.h"

namespace pbrt {

/// The BxDFs of sixteen surfaces: their own, or, with Option "forcediffuse", matt ones that reflect
/// as much. Theirs is DiffuseBxDF of AlbedoOf towards wo (with its errors), at most 1: mirrors and
/// glass become matt, and nothing is let through. pbrt-v4 takes a random estimate of the same.
template <BxDFType BxDF>
class SurfacePacketBSDF {
  public:
    explicit SurfacePacketBSDF(bool forceDiffuse) : forceDiffuse(forceDiffuse) {}

    void Set(int i, const BxDFPacketInput<BxDF> &input) { own.Set(i, input); }
    template <BxDFType B>
    void SetDiffuse(int i, const B &bxdf, Vector3f wo) {
        SampledSpectrum albedo = AlbedoOf(bxdf, wo);
        for (int k = 0; k < NSpectrumSamples; ++k)
            albedo.Set(k, std::min(albedo[k], 1.f));
        diffuse.Set(i, DiffuseBxDF(albedo));
    }
    void Regularize(int i) {
        if (!forceDiffuse) own.Regularize(i);
    }
    BxDFFlags Flags(int i) const { return forceDiffuse ? diffuse.Flags(i) : own.Flags(i); }
    BxDFValues Evaluate(const Vector3fX16 &wo, const Vector3fX16 &wi, LaneBits active) {
        if (forceDiffuse) [[unlikely]]
            return diffuse.Evaluate(wo, wi, active);
        return own.Evaluate(wo, wi, active);
    }
    BxDFSamples Sample(const Vector3fX16 &wo, const FloatX16 &uc, const Point2fX16 &u,
                       LaneBits active) {
        if (forceDiffuse) [[unlikely]]
            return diffuse.Sample(wo, uc, u, active);
        return own.Sample(wo, uc, u, active);
    }

  private:
    bool forceDiffuse;
    BxDFPacket<BxDF> own;
    BxDFPacket<DiffuseBxDF> diffuse;
};

}  // namespace pbrt
