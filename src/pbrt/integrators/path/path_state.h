#pragma once

#include <array>

#include "pbrt/base/hit.h"
#include "pbrt/base/integrator.h"
#include "pbrt/base/light.h"

namespace pbrt {

/// State that a path carries from one vertex to the next; the last two are for MIS weights.
struct PathState {
    Ray ray;
    SampledSpectrum beta;
    LightSampleContext previous;  ///< the vertex that ray.d was drawn at
    float bsdfPDF;                ///< of ray.d there; 0: from the camera or a delta lobe
};

/// Sixteen paths side by side.
struct PathPacket {
    UintX16 slot;  ///< a path's number in its batch
    Point3fX16 o;
    Vector3fX16 d;
    FloatX16 time;
    Point3fX16 p;  ///< of PathState::previous, as is the next
    Normal3fX16 ns;
    FloatX16 bsdfPDF, etaScale;
    UintX16 depth, anyNonSpecular;
    std::array<SampledSpectrum, kPacketSize> beta;

    PathState At(int i) const {
        return {{Lane(o, i), Lane(d, i), Infinity, time[i]},
                beta[size_t(i)],
                {Lane(p, i), Lane(ns, i), time[i]},
                bsdfPDF[i]};
    }
};

/// The random numbers of one vertex of sixteen paths, in the order of their dimensions.
struct VertexNumbers {
    static constexpr int kDimensions = 5;
    FloatX16 light;  ///< which light
    Point2fX16 lightPoint;
    FloatX16 lobe;  ///< which lobe of the BSDF
    Point2fX16 direction;
    FloatX16 roulette;

    /// The numbers that are read: the others are not drawn.
    struct Wanted {
        bool light, lobe;
    };
    template <typename SamplerT>
    static VertexNumbers Draw(SamplerT &sampler, int dimension, const UintX16 &pixel,
                              const UintX16 &sample, Wanted wanted) {
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
