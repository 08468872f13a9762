// Closed meshes keep rays inside, and what is found does not depend on the number of threads.

#include "accel/trace.h"

namespace pbrt {
namespace {

/// A sphere of 2 * nPhi * (nTheta - 1) triangles.
TriangleMesh Globe(uint32_t nPhi, uint32_t nTheta, Point3f center) {
    TriangleMesh mesh;
    mesh.p.push_back(center + Vector3f{0, 0, 1});
    for (uint32_t j = 1; j < nTheta; ++j)
        for (uint32_t i = 0; i < nPhi; ++i) {
            const float theta = Pi * float(j) / float(nTheta);
            const float phi = 2 * Pi * float(i) / float(nPhi);
            mesh.p.push_back(center + Vector3f{std::sin(theta) * std::cos(phi),
                                               std::sin(theta) * std::sin(phi), std::cos(theta)});
        }
    const uint32_t bottom = uint32_t(mesh.p.size());
    mesh.p.push_back(center - Vector3f{0, 0, 1});
    const auto at = [&](uint32_t j, uint32_t i) {
        return j == 0 ? 0 : j == nTheta ? bottom : 1 + (j - 1) * nPhi + i % nPhi;
    };
    for (uint32_t j = 0; j < nTheta; ++j)
        for (uint32_t i = 0; i < nPhi; ++i) {
            const uint32_t a = at(j, i), b = at(j, i + 1), c = at(j + 1, i), d = at(j + 1, i + 1);
            if (j > 0) mesh.indices.insert(mesh.indices.end(), {a, c, b});
            if (j + 1 < nTheta) mesh.indices.insert(mesh.indices.end(), {b, c, d});
        }
    return mesh;
}

TEST(ClosedMesh, LetsNoRayOut) {
    for (const float distance : {0.f, 1000.f}) {
        const Point3f center = distance * Point3f{1, 0.3f, -0.7f};
        std::vector<Geometry> geometries{Traced::Of(Globe(512, 256, center))};
        const Accel accel(geometries, 1, {}, {}, 2);
        Rng rng(4);
        int out = 0;
        for (int i = 0; i < 1000000; ++i) {
            const Ray ray{center + RandomPoint(rng, 0.5f), RandomDirection(rng)};
            out += !accel.Occluded(ray);
        }
        EXPECT_EQ(out, 0) << "at distance " << distance;
    }
}

TEST(Accel, FindsTheSameWithAnyNumberOfThreads) {
    std::vector<Geometry> geometries{Traced::Of(Globe(256, 128, {}))};
    const Accel one(geometries, 1, {}, {}, 1);
    Rng rng(4);
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    const auto &mesh = std::get<TriangleMesh>(geometries[0].shape);
    for (int i = 0; i < 100000; ++i) {
        // Half of them at edges, where two triangles are met at the same place.
        const Point3f o = RandomPoint(rng, 0.5f);
        const uint32_t t = 3 * rng.Below(uint32_t(mesh.NPrimitives()));
        const Point3f edge =
            Lerp(rng.Uniform(), mesh.p[mesh.indices[t]], mesh.p[mesh.indices[t + 1]]);
        rays.push_back({o, i % 2 == 0 ? RandomDirection(rng) : edge - o});
        Hit hit{};
        one.Intersect(rays.back(), &hit);
        hits.push_back(hit);
    }
    const Accel two(geometries, 1, {}, {}, 2);
    for (size_t i = 0; i < rays.size(); ++i) {
        Hit hit{};
        two.Intersect(rays[i], &hit);
        EXPECT_EQ(hit.primitive, hits[i].primitive);
        EXPECT_EQ(hit.t, hits[i].t);
    }
}

}  // namespace
}  // namespace pbrt
