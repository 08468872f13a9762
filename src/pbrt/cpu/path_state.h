#pragma once

#include "pbrt/lights/light.h"

namespace pbrt {

/// Rays traced; each thread counts its own.
struct RayCounts {
    int64_t closest = 0, shadow = 0;
    RayCounts &operator+=(const RayCounts &b) {
        return closest += b.closest, shadow += b.shadow, *this;
    }
};

/// What a path takes from one vertex to the next.
struct PathState {
    Ray ray;
    SampledSpectrum beta;
    LightSampleContext previous;  ///< the vertex that ray.d was drawn at
    float bsdfPDF = 0;            ///< of ray.d there; 0: from the camera or a delta lobe
    float etaScale = 1;
    int depth = 0;
    bool anyNonSpecular = false;
};

/// The random numbers of one vertex, in the order of their dimensions.
struct VertexNumbers {
    static constexpr int kDimensions = 5;
    float light;        ///< which light
    Point2f lightPoint;
    float lobe;         ///< which lobe of the BSDF
    Point2f direction;
    float roulette;
};

/// Light that arrives unless something stands between.
struct ShadowTest {
    Point3f from, to;
    SampledSpectrum light;  ///< what the path gains; 0: nothing to test
};

}  // namespace pbrt
