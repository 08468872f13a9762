#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "pbrt/accel/accel.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// Geometries with the Accel over them. All surfaces pass light, so that a query can list all hits
/// of a ray through traversal itself, not only the nearest.
class Traced {
  public:
    explicit Traced(std::vector<Geometry> list) : geometries(std::move(list)) {
        for (Geometry &g : geometries)
            g.hasNullTransmission = true;
        accel.emplace(geometries, uint32_t(geometries.size()), std::span<const ObjectRange>(),
                      std::span<const Instance>(), 2);
        EXPECT_EQ(accel->Error(), "");
    }
    static Geometry Of(Shape shape) {
        Geometry g;
        g.shape = std::move(shape);
        return g;
    }

    std::vector<Hit> AllHits(const Ray &ray) const {
        struct Collect final : NullTransmission {
            std::vector<Hit> *hits;
            float operator()(const Hit &hit, const Ray &) const override {
                hits->push_back(hit);
                return 1;
            }
        } collect;
        std::vector<Hit> hits;
        collect.hits = &hits;
        EXPECT_EQ(accel->Transmittance(ray, collect), 1);
        return hits;
    }
    /// The hits with one primitive.
    std::vector<Hit> HitsWith(const Ray &ray, uint32_t geometry, uint32_t primitive) const {
        std::vector<Hit> hits;
        for (const Hit &h : AllHits(ray))
            if (h.geometry == geometry && h.primitive == primitive) hits.push_back(h);
        return hits;
    }
    SurfaceInteraction At(const Hit &hit, const Ray &ray) const {
        return SurfaceAt(geometries[hit.geometry].shape, hit, ray);
    }

    std::vector<Geometry> geometries;
    std::optional<Accel> accel;
};

inline Vector3f RandomDirection(Rng &rng) {
    return SampleUniformSphere(rng.Uniform2D());
}
/// In a cube of half width r about 0.
inline Point3f RandomPoint(Rng &rng, float r) {
    const float x = rng.Uniform(), y = rng.Uniform(), z = rng.Uniform();
    return r * Vector3f{2 * x - 1, 2 * y - 1, 2 * z - 1};
}
/// 10^x with x uniform.
inline float RandomScale(Rng &rng, float lo, float hi) {
    return std::pow(10.f, Lerp(rng.Uniform(), lo, hi));
}

}  // namespace pbrt
