#pragma once

#include <array>

#include "pbrt/accel/packet.h"
#include "pbrt/lights/light.h"

namespace pbrt {

/// Rays traced; each thread counts its own.
struct RayCounts {
    int64_t closest = 0, shadow = 0;
    RayCounts &operator+=(const RayCounts &b) {
        return closest += b.closest, shadow += b.shadow, *this;
    }
};

/// What a path takes from one vertex to the next, and what finding light must know of it.
struct PathState {
    Ray ray;
    SampledSpectrum beta;
    LightSampleContext previous;  ///< the vertex that ray.d was drawn at
    float bsdfPDF;                ///< of ray.d there; 0: from the camera or a delta lobe
};

/// Sixteen paths side by side.
struct PathLanes {
    WideUint slot;  ///< a path's number in its batch
    WidePoint3f o;
    WideVector3f d;
    WideFloat time;
    WidePoint3f p;  ///< of PathState::previous, as is the next
    WideNormal3f ns;
    WideFloat bsdfPDF, etaScale;
    WideUint depth, anyNonSpecular;
    std::array<SampledSpectrum, kWide> beta;

    PathState At(int i) const {
        return {{Lane(o, i), Lane(d, i), Infinity, time[i]},
                beta[size_t(i)],
                {Lane(p, i), Lane(ns, i)},
                bsdfPDF[i]};
    }
};

/// The random numbers of one vertex of sixteen paths, in the order of their dimensions.
struct VertexNumbers {
    static constexpr int kDimensions = 5;
    WideFloat light;  ///< which light
    WidePoint2f lightPoint;
    WideFloat lobe;  ///< which lobe of the BSDF
    WidePoint2f direction;
    WideFloat roulette;

    /// Those that nobody reads are left out: `wanted`.
    struct Wanted {
        bool light, lobe;
    };
    template <typename SamplerT>
    static VertexNumbers Draw(SamplerT &sampler, int dimension, const WideUint &pixel,
                              const WideUint &sample, Wanted wanted) {
        VertexNumbers n{};
        if (wanted.light) n.light = sampler.Get1D(dimension, pixel, sample);
        n.lightPoint = sampler.Get2D(dimension + 1, pixel, sample);
        if (wanted.lobe) n.lobe = sampler.Get1D(dimension + 2, pixel, sample);
        n.direction = sampler.Get2D(dimension + 3, pixel, sample);
        n.roulette = sampler.Get1D(dimension + 4, pixel, sample);
        return n;
    }
};

}  // namespace pbrt
