#pragma once

#include <optional>

#include "pbrt/base/bxdf.h"
#include "pbrt/feather/barbule.h"

namespace pbrt {

/// Input of a feather's BxDF at a point.
struct FeatherSurface {
    feather::Vane<float> vane;
    std::optional<float> tilt;  ///< of the barbules, if other than the vane's; rad
    float thickness;            ///< of the film, nm
    float roughness;            ///< standard deviation of the thickness, nm
    feather::Optics<float, NSpectrumSamples> optics;

    feather::Vane<float> TiltedVane() const {
        feather::Vane<float> tilted = vane;
        if (tilt) tilted.row.Tilt(true, {*tilt});
        return tilted;
    }
};

class FeatherBarbulePacket;

/// Thin adapter of feather::Barbule to the renderer's conventions; all mathematics is there.
/// Local frame: z the normal, y along the barbules, x across them; lives on both sides.
class FeatherBarbuleBxDF {
  public:
    static constexpr BxDFTraits kTraits{.evaluatesTogether = true, .hasPacket = true};
    using Packet = FeatherBarbulePacket;  ///< in feather_barbule_packet.h
    using PacketInput = FeatherSurface;
    using Model = feather::Barbule<float, NSpectrumSamples>;
    static constexpr BxDFFlags kFlags =
        BxDFFlags::Reflection | BxDFFlags::Transmission | BxDFFlags::Glossy | BxDFFlags::Diffuse;

    explicit FeatherBarbuleBxDF(const Model &barbule) : barbule(barbule) {}
    explicit FeatherBarbuleBxDF(const FeatherSurface &at)
        : barbule(at.TiltedVane(), {at.thickness}, at.optics, {at.roughness}) {}

    BxDFFlags Flags() const { return kFlags; }
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const {
        return SampledSpectrum(barbule.f(Local(wo), Local(wi)));
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const {
        return barbule.PDF(barbule.SeenFrom(Local(wo)), Local(wi));
    }
    BSDFEval Evaluate(Vector3f wo, Vector3f wi, TransportMode) const {
        const auto view = barbule.SeenFrom(Local(wo));
        const auto in = Local(wi);
        return {SampledSpectrum(barbule.f(view, in)), barbule.PDF(view, in)};
    }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float uc, Point2f u, TransportMode) const {
        const auto s = barbule.Sample_f(barbule.SeenFrom(Local(wo)), uc, u.x, u.y);
        if (!s) return {};
        const Vector3f wi{s->wi.x, s->wi.y, s->wi.z};
        const BxDFFlags side =
            SameHemisphere(wo, wi) ? BxDFFlags::Reflection : BxDFFlags::Transmission;
        return BSDFSample{
            SampledSpectrum(s->f), wi, s->pdf,
            s->isGap ? BxDFFlags::Transmission | BxDFFlags::Specular | BxDFFlags::NullTransmission
                     : side | BxDFFlags::Glossy};
    }
    /// The two terms of f by themselves.
    struct LobeValues {
        SampledSpectrum R, TRT;
    };
    LobeValues Lobes(Vector3f wo, Vector3f wi) const {
        const auto view = barbule.SeenFrom(Local(wo));
        return {SampledSpectrum(barbule.R(view, Local(wi))),
                SampledSpectrum(barbule.TRT(view, Local(wi)))};
    }
    /// Fraction of light from w that passes straight through.
    float GapFraction(Vector3f w) const { return barbule.GapFraction(Local(w)); }

  private:
    static feather::Direction<float> Local(Vector3f w) { return {w.x, w.y, w.z}; }
    Model barbule;
};
static_assert(BxDFType<FeatherBarbuleBxDF>);

}  // namespace pbrt
