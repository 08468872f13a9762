#pragma once

#include <cmath>

#include "pbrt/base/bxdf.h"

namespace pbrt {

/// Share of even light from all around that a BxDF sends to wo, straight passage included, from 16
/// fixed samples: exact where sampling is, some hundredths off for others.
template <BxDFType B>
SampledSpectrum AlbedoOf(const B &bxdf, Vector3f wo) {
    constexpr int kSamples = 16;
    SampledSpectrum sum(0);
    for (int i = 0; i < kSamples; ++i) {
        // Evenly spread points: multiples of powers of the plastic number (Roberts 2018).
        const auto spread = [&](double step) {
            return std::min(float(std::fmod(0.5 + (i + 1) * step, 1.0)), OneMinusEpsilon);
        };
        const Point2f u{spread(0.7548776662466927), spread(0.5698402909980532)};
        const float uc = (float(i) + 0.5f) / kSamples;
        const auto s = bxdf.Sample_f(wo, uc, u, TransportMode::Radiance);
        if (s && s->pdf > 0) sum += s->f * (AbsCosTheta(s->wi) / s->pdf);
    }
    return sum / kSamples;
}

}  // namespace pbrt
