#pragma once

#include <array>
#include <optional>

#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// Where light arrives. ns: the shading normal on the side from which the receiver takes light, 0
/// where it takes light from all sides.
struct LightSampleContext {
    Point3f p;
    Normal3f ns;
};

/// Sixteen receivers.
struct LightSampleContextX16 {
    Point3fX16 p;
    Normal3fX16 ns;

    LightSampleContext At(int i) const { return {Lane(p, i), Lane(ns, i)}; }
};

/// Light from one sampled direction.
struct LightLiSample {
    SampledSpectrum L;
    Vector3f wi;
    float pdf;       ///< per unit solid angle; 1 for delta lights
    Point3f pLight;  ///< end of the shadow ray (already moved off the light's surface)
    bool delta;      ///< point, spot, distant: no BSDF sample can find it
};

/// Sixteen of LightLiSample.
struct LightLiSamples {
    std::array<SampledSpectrum, kPacketSize> L;
    Vector3fX16 wi{};
    FloatX16 pdf{};
    Point3fX16 pLight{};
    LaneBits valid = 0, delta = 0;

    void Set(int i, const LightLiSample &s) {
        L[size_t(i)] = s.L;
        SetLane(&wi, i, s.wi);
        pdf.Set(i, s.pdf);
        SetLane(&pLight, i, s.pLight);
        valid |= LaneBits(1) << i;
        delta |= LaneBits(s.delta) << i;
    }
};

// Each light type is a struct in its own file with these members:
//   static constexpr std::string_view kName
//   std::optional<LightLiSample> SampleLi(const LightSampleContext &, Point2f u,
//                                         const SampledWavelengths &) const
//   float Power() const     luminous flux (pbrt's units: 1 = one rgb unit), for choosing lights
//   std::optional<LightBounds> Bounds() const     nullopt for light from infinity
// and, where it has them:
//   void Preprocess(float radius)         of the scene's bounding sphere
//   float PDF_Li(Vector3f wi) const       infinite lights with an area
//   SampledSpectrum Le(Vector3f d, const SampledWavelengths &) const
// lights.h gathers them in the variant `Light`.

}  // namespace pbrt
