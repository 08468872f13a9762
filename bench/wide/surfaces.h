#pragma once

#include <memory>
#include <string>

#include "bench/stopwatch.h"
#include "pbrt/shapes/surface_packet.h"
#include "pbrt/util/rng.h"

namespace pbrt::bench {

inline Point3f RandomPoint(Rng &rng) {
    const float x = rng.Uniform(), y = rng.Uniform(), z = rng.Uniform();
    return {x, y, z};
}

/// Triangles of corners in a row of memory, as a mesh in order has them; with normals and uv or
/// bare.
inline TriangleMesh BenchMesh(Rng &rng, bool bare) {
    TriangleMesh mesh;
    for (uint32_t i = 0; i < 3000; ++i) {
        mesh.indices.push_back(i);
        mesh.p.push_back(RandomPoint(rng));
        if (bare) continue;
        mesh.n.push_back(RandomPoint(rng));
        mesh.uv.push_back(rng.Uniform2D());
    }
    return mesh;
}
inline BilinearMesh BenchPatches(Rng &rng) {
    BilinearMesh mesh;
    for (uint32_t i = 0; i < 20; ++i) {
        const Point3f p = RandomPoint(rng), a = RandomPoint(rng), b = RandomPoint(rng);
        mesh.p.insert(mesh.p.end(), {p, p + a, p + b, p + a + b});
        mesh.indices.insert(mesh.indices.end(), {4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
    }
    mesh.planar = true;
    return mesh;
}

inline void AddSurface(Stopwatch &watch, const std::string &name, Rng &rng,
                       std::vector<Shape> list) {
    constexpr int kPackets = 64;
    struct One {
        const Shape *shape;
        Hit hit;
        Ray ray;
    };
    struct Work {
        std::vector<Shape> shapes;
        std::vector<PacketHits> hits;
        std::vector<One> ones;
    };
    const auto work = std::make_shared<Work>();
    work->shapes = std::move(list);
    work->hits.resize(kPackets);
    for (PacketHits &met : work->hits)
        for (int i = 0; i < kPacketSize; ++i) {
            const size_t which = rng.Below(uint32_t(work->shapes.size()));
            met.shape[size_t(i)] = &work->shapes[which];
            met.hit.primitive.Set(
                i, rng.Below(uint32_t(std::visit([](const auto &s) { return s.NPrimitives(); },
                                                 work->shapes[which]))));
            met.hit.geometry.Set(i, uint32_t(which)), met.hit.instance.Set(i, ~0u);
            met.hit.u.Set(i, 0.5f * rng.Uniform()), met.hit.v.Set(i, 0.5f * rng.Uniform());
            met.hit.t.Set(i, rng.Uniform());
            SetLane(&met.o, i, RandomPoint(rng));
            SetLane(&met.d, i, RandomPoint(rng));
            const HitPacket &h = met.hit;
            work->ones.push_back(
                {met.shape[size_t(i)],
                 {h.t[i], h.u[i], h.v[i], h.geometry[i], h.primitive[i], h.instance[i]},
                 {Lane(met.o, i), Lane(met.d, i)}});
        }
    const int calls = kPackets * kPacketSize;
    watch.Add(name + " scalar", calls, [=] {
        float sum = 0;
        for (const One &one : work->ones) {
            const SurfaceInteraction s = SurfaceAt(*one.shape, one.hit, one.ray);
            sum += s.p.x + s.pError.y + s.n.z + s.ns.x + s.dpdus.x + s.uv.x;
        }
        return sum;
    });
    const auto wide = [=]<bool kWithTangents>(std::bool_constant<kWithTangents>) {
        FloatX16 sum{};
        for (const PacketHits &met : work->hits) {
            const SurfaceInteractionX16 s = SurfacePacket<kWithTangents>(met, kAllLanes);
            sum += s.p.x + s.pError.y + s.n.z + s.ns.x;
            if constexpr (kWithTangents) sum += s.dpdus.x + s.uv.x;
        }
        return double(sum[0]);
    };
    watch.Add(name + " wide", calls, [=] { return wide(std::true_type()); });
    watch.Add(name + " wide, no tangents", calls, [=] { return wide(std::false_type()); });
}

inline void AddSurfaces(Stopwatch &watch) {
    Rng rng(1);
    AddSurface(watch, "bare triangles", rng, {BenchMesh(rng, true)});
    AddSurface(watch, "smooth triangles", rng, {BenchMesh(rng, false)});
    AddSurface(watch, "flat patches", rng, {BenchPatches(rng)});
    std::vector<Shape> spheres;
    for (int i = 0; i < 5; ++i)
        spheres.push_back(Sphere{Transform::Translate(RandomPoint(rng))});
    AddSurface(watch, "spheres", rng, spheres);
    AddSurface(watch, "all three", rng, {BenchMesh(rng, true), BenchPatches(rng), spheres[0]});
}

}  // namespace pbrt::bench
