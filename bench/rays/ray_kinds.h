#pragma once

#include <algorithm>
#include <vector>

#include "pbrt/build/render_scene.h"
#include "pbrt/lights/light_sampler.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt::bench {

/// Rays of one kind in the order of their tracing, singly and in packets. A packet holds rays of
/// one batch at one step, so some have empty lanes.
struct RayKind {
    const char *name;
    std::vector<Ray> rays = {};
    std::vector<RayPacket> packets = {};
    std::vector<LaneBits> active = {};

    void Append(const std::vector<Ray> &step) {
        rays.insert(rays.end(), step.begin(), step.end());
        for (size_t i = 0; i < step.size(); ++i) {
            if (i % kPacketSize == 0) {
                packets.emplace_back();
                active.push_back(0);
            }
            packets.back().Set(int(i % kPacketSize), step[i]);
            active.back() |= 1u << i % kPacketSize;
        }
    }
};

/// What diffuse paths trace in batches of 16 neighbouring pixels by 64 samples, step by step: rays
/// from the camera, cosine-distributed bounces (up to four), and a shadow ray at each vertex that a
/// light was drawn for. The bounces also sorted by octant.
class RayKinds {
  public:
    explicit RayKinds(const RenderScene &world)
        : world(world), lightSampler(LightSampler::Create("bvh", world.lights)), rng(1) {
        const Point2i resolution = world.film.FullResolution();
        for (int batch = 0; batch < kBatches; ++batch)
            Trace({std::floor(rng.Uniform() * (resolution.x - 4)),
                   std::floor(rng.Uniform() * (resolution.y - 4))});
    }
    RayKind camera{"camera"}, bounce{"bounce"}, byOctant{"bounce by octant"}, shadow{"shadow"};

  private:
    static constexpr int kBatches = 100, kSamples = 64, kMaxBounces = 4;

    void Trace(Point2f corner) {
        std::vector<Ray> rays;
        for (int pixel = 0; pixel < 16; ++pixel)
            for (int k = 0; k < kSamples; ++k) {
                const Point2f in = rng.Uniform2D(), lens = rng.Uniform2D();
                const Point2f film{corner.x + pixel % 4 + in.x, corner.y + pixel / 4 + in.y};
                rays.push_back(GenerateRay(world.camera, film, lens, rng.Uniform()));
            }
        for (int step = 0; step <= kMaxBounces; ++step) {
            (step == 0 ? camera : bounce).Append(rays);
            if (step > 0) byOctant.Append(SortedByOctant(rays));
            std::vector<Ray> next, shadows;
            for (const Ray &ray : rays)
                Scatter(ray, &next, &shadows);
            shadow.Append(shadows);
            rays = std::move(next);
        }
    }

    static std::vector<Ray> SortedByOctant(std::vector<Ray> rays) {
        std::stable_sort(rays.begin(), rays.end(),
                         [](const Ray &a, const Ray &b) { return Octant(a.d) < Octant(b.d); });
        return rays;
    }

    void Scatter(const Ray &ray, std::vector<Ray> *next, std::vector<Ray> *shadows) {
        Hit hit;
        if (!world.accel->Intersect(ray, &hit)) return;
        const SurfaceInteraction sp = world.SurfaceAt(hit, ray);
        const Normal3f n = Dot(sp.n, ray.d) > 0 ? -sp.n : sp.n;
        const LightSampleContext ctx{sp.p, n};
        const auto lambda = SampledWavelengths::SampleVisible(rng.Uniform());
        const float uLight = rng.Uniform();
        const Point2f u = rng.Uniform2D();
        if (const auto chosen = lightSampler.Sample(ctx, uLight)) {
            const auto ls = SampleLi(world.lights[size_t(chosen->light)], ctx, u, lambda);
            if (ls && Dot(ls->wi, n) > 0) {
                const Point3f from = sp.OffsetOrigin(ls->wi);
                shadows->push_back({from, ls->pLight - from, 1 - 1e-4f, ray.time});
            }
        }
        const Vector3f w = Frame::FromZ(n).FromLocal(SampleCosineHemisphere(rng.Uniform2D()));
        next->push_back({sp.OffsetOrigin(w), w, Infinity, ray.time});
    }

    const RenderScene &world;
    LightSampler lightSampler;
    Rng rng;
};

}  // namespace pbrt::bench
