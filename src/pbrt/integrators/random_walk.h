#pragma once

#include "pbrt/build/visit_bsdf.h"
#include "pbrt/integrators/found_light.h"
#include "pbrt/integrators/max_depth.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// `randomwalk`: at every surface a direction drawn evenly from the sphere, and light where the
/// walk happens to meet it. The rendering equation with nothing else; noisy. Point and distant
/// lights, mirrors, glass and gaps between barbules, which no such direction finds, are black.
class RandomWalkIntegrator {
  public:
    static constexpr std::string_view kName = "randomwalk";
    static constexpr IntegratorTraits kTraits{};

    static RandomWalkIntegrator Create(ParamDict &params) {
        RandomWalkIntegrator i;
        i.maxDepth = params.GetOneInt(kMaxDepth);
        return i;
    }
    void Preprocess(const RenderScene &) {}

    template <typename SamplerT>
    SampledSpectrum Li(const RenderScene &scene, Ray ray, SampledWavelengths *lambda,
                       SamplerT *sampler, RayCounts *counts) const {
        SampledSpectrum L(0), beta(1);
        for (int depth = 0;; ++depth) {
            Hit hit;
            ++counts->closest;
            if (!scene.accel->Intersect(ray, &hit)) {
                for (const int light : scene.infiniteLights)
                    L += beta * Le(scene.lights[size_t(light)], ray, *lambda);
                return L;
            }
            const SurfaceInteraction sp = scene.SurfaceAt(hit, ray);
            if (const int light = LightAt(scene, hit); light >= 0)
                L +=
                    beta * pbrt::L(scene.lights[size_t(light)], sp.p, sp.n, sp.uv, -ray.d, *lambda);
            if (depth == maxDepth) return L;
            const Vector3f d = SampleUniformSphere(sampler->Get2D());
            beta *=
                VisitBSDF(scene, hit, sp, ray, lambda, &counts->clamped,
                          [&](const Frame &frame, const auto &bxdf) {
                              const Vector3f wi = frame.ToLocal(d);
                              return bxdf.f(frame.ToLocal(-ray.d), wi, TransportMode::Radiance) *
                                     (AbsCosTheta(wi) * 4 * Pi);
                          });
            if (!beta) return L;
            ray = {sp.OffsetOrigin(d), d, Infinity, ray.time};
        }
    }

  private:
    int maxDepth = 5;
};

}  // namespace pbrt
