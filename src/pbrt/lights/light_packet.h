#pragma once

#include <array>

#include "pbrt/lights/lights.h"
#include "pbrt/util/lanes_by_type.h"

namespace pbrt {

using LightPacket = std::array<const Light *, kPacketSize>;

/// SampleLi of light[lane] in the given lanes, those without a light (nullptr) apart. What is
/// sampled becomes valid; other lanes' wi, pdf and pLight become undefined.
[[gnu::always_inline]] inline void SampleLi(const LightPacket &light,
                                            const LightSampleContextX16 &ctx, const Point2fX16 &u,
                                            const WavelengthPacket &lambda, LaneBits lanes,
                                            LightLiSamples *samples) {
    const LanesByType<LightTypes> types(light, lanes);
    LaneBits left = types.All();
    LightTypes::ForEach([&]<typename L>() {
        if constexpr (L::kTraits.isWide) {
            const LaneBits own = types.Of<L>();
            if (own == 0) return;
            LightsOf<L> lights{};
            ForEachLane(own, [&](int i) { lights[size_t(i)] = std::get_if<L>(light[size_t(i)]); });
            left &= ~L::SampleLi(lights, ctx, u, lambda, own, samples);
        }
    });
    ForEachLane(left, [&](int i) {
        const auto s = SampleLi(*light[size_t(i)], ctx.At(i), Lane(u, i), *lambda[size_t(i)]);
        if (s) samples->Set(i, *s);
    });
}

/// Le of an infinite light along rays from o, in the given lanes; the others become undefined.
inline void Le(const Light &light, const Point3fX16 &o, const Vector3fX16 &d,
               const WavelengthPacket &lambda, LaneBits lanes, LightLePacket *le) {
    Dispatch(light, [&]<typename L>(const L &l) {
        if constexpr (L::kTraits.isWideSeen) return l.Le(d, lambda, lanes, le);
        ForEachLane(lanes, [&](int i) {
            le->L[size_t(i)] = Le(light, Ray{Lane(o, i), Lane(d, i)}, *lambda[size_t(i)]);
            le->pdf.Set(i, PDF_Li(light, Lane(o, i), Lane(d, i)));
        });
    });
}

}  // namespace pbrt
