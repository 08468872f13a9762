#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "pbrt/base/bxdf.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt::test {

/// A BxDF with some parameters, and what is claimed of it.
template <typename B>
struct BxDFCase {
    std::string name;
    B bxdf;
    float eta = 1;           ///< index below the surface over that above
    bool reciprocal = true;  ///< f(wo, wi) / n(wo)^2 is symmetric, n being the index on that side
    /// Relative difference allowed between a sample's f and pdf and those of its directions: what
    /// rounding of the directions can do to the sharpest lobe.
    float sampleTolerance = 1e-3f;

    friend std::ostream &operator<<(std::ostream &out, const BxDFCase &c) { return out << c.name; }
};

/// Unit directions on both sides: cosine-distributed ones, the same for every type, and a grazing
/// one.
inline std::vector<Vector3f> Outgoing(int n) {
    Rng rng(11);
    std::vector<Vector3f> directions{Normalize(Vector3f{0.6f, -0.8f, 0.07f})};
    while (int(directions.size()) < n) {
        Vector3f w = SampleCosineHemisphere(rng.Uniform2D());
        if (directions.size() % 2) w.z = -w.z;
        directions.push_back(w);
    }
    return directions;
}

inline constexpr TransportMode kModes[]{TransportMode::Radiance, TransportMode::Importance};

}  // namespace pbrt::test
