#pragma once

#include "pbrt/build/surface_bsdf.h"
#include "pbrt/bxdfs/bxdf_packet.h"

namespace pbrt {

/// The BxDFs of sixteen surfaces: their own, or, with Option "forcediffuse", diffuse ones that
/// reflect as much (DiffuseOf).
template <BxDFType BxDF>
class SurfacePacketBSDF {
  public:
    explicit SurfacePacketBSDF(bool forceDiffuse) : forceDiffuse(forceDiffuse) {}

    void Set(int i, const BxDFPacketInput<BxDF> &input) { own.Set(i, input); }
    template <BxDFType B>
    void SetDiffuse(int i, const B &bxdf, Vector3f wo) {
        diffuse.Set(i, DiffuseOf(bxdf, wo));
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
