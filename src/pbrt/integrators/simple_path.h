#pragma once

#include "pbrt/build/visit_bsdf.h"
#include "pbrt/integrators/found_light.h"
#include "pbrt/integrators/max_depth.h"
#include "pbrt/lights/light_sampler.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// `simplepath`: path tracing as a book explains it, without multiple importance sampling, Russian
/// roulette or packets. Of use to check the path integrator and to see what these gain.
///
/// samplelights: lights are sampled at every vertex, each with the same probability, and what a ray
/// happens to hit counts only where no light sampling could have found it. samplebsdf: directions
/// are drawn from the BSDF, else evenly from the hemisphere or, where light passes, the sphere;
/// mirrors and glass are then black.
class SimplePathIntegrator {
  public:
    static constexpr std::string_view kName = "simplepath";
    static constexpr IntegratorTraits kTraits{};
    static constexpr BoolParam kSampleLights{"samplelights", true,
                                             "lights are sampled at every vertex"};
    static constexpr BoolParam kSampleBSDF{"samplebsdf", true,
                                           "directions are drawn from the BSDF, else evenly"};

    static SimplePathIntegrator Create(ParamDict &params) {
        SimplePathIntegrator i;
        i.maxDepth = params.GetOneInt(kMaxDepth);
        i.sampleLights = params.GetOneBool(kSampleLights);
        i.sampleBSDF = params.GetOneBool(kSampleBSDF);
        return i;
    }
    void Preprocess(const RenderScene &scene) {
        lightSampler = LightSampler::Create("uniform", scene.lights);
    }

    template <typename SamplerT>
    SampledSpectrum Li(const RenderScene &scene, Ray ray, SampledWavelengths *lambda,
                       SamplerT *sampler, RayCounts *counts) const {
        SampledSpectrum L(0), beta(1);
        LightSampleContext previous{};
        bool countsAll = true;  // whether light that the ray meets counts, whichever it is
        for (int depth = 0; beta;) {
            const auto counted = [&](int light) {
                return countsAll || lightSampler.PMF(previous, light) == 0;
            };
            Hit hit;
            ++counts->closest;
            if (!scene.accel->Intersect(ray, &hit)) {
                for (const int light : scene.infiniteLights)
                    if (counted(light)) L += beta * Le(scene.lights[size_t(light)], ray, *lambda);
                break;
            }
            const SurfaceInteraction sp = scene.SurfaceAt(hit, ray);
            if (const int light = LightAt(scene, hit); light >= 0 && counted(light))
                L +=
                    beta * pbrt::L(scene.lights[size_t(light)], sp.p, sp.n, sp.uv, -ray.d, *lambda);
            const bool last = depth == maxDepth;
            VisitBSDF(scene, hit, sp, ray, lambda, &counts->clamped,
                      [&](const Frame &frame, const auto &bxdf) {
                          const Vector3f wo = frame.ToLocal(-ray.d);
                          if (!last && sampleLights)
                              L += beta * Direct(scene, sp, ray.time, frame, bxdf, wo, *lambda,
                                                 sampler, counts);
                          const auto s = Scatter(bxdf, wo, sampler);
                          // Straight through is no bounce: what is found behind counts as before.
                          const bool straight = s && Has(s->flags, BxDFFlags::NullTransmission);
                          if (!s || s->pdf == 0 || (last && !straight))
                              return void(beta = SampledSpectrum(0));
                          beta *= s->f * (AbsCosTheta(s->wi) / s->pdf);
                          const Vector3f d = straight ? ray.d : frame.FromLocal(s->wi);
                          ray = {sp.OffsetOrigin(d), d, Infinity, ray.time};
                          if (straight) return;
                          countsAll = !sampleLights || IsSpecular(s->flags);
                          previous = {sp.p, {}, ray.time};
                          ++depth;
                      });
        }
        return L;
    }

  private:
    /// Light of one light, reflected.
    template <typename BxDF, typename SamplerT>
    SampledSpectrum Direct(const RenderScene &scene, const SurfaceInteraction &sp, float time,
                           const Frame &frame, const BxDF &bxdf, Vector3f wo,
                           const SampledWavelengths &lambda, SamplerT *sampler,
                           RayCounts *counts) const {
        const LightSampleContext ctx{sp.p, {}, time};
        const float uLight = sampler->Get1D();
        const Point2f u = sampler->Get2D();
        const auto chosen = lightSampler.Sample(ctx, uLight);
        if (!chosen) return SampledSpectrum(0);
        const auto ls = SampleLi(scene.lights[size_t(chosen->light)], ctx, u, lambda);
        if (!ls || ls->pdf == 0) return SampledSpectrum(0);
        const Vector3f wi = frame.ToLocal(ls->wi);
        const SampledSpectrum f = bxdf.f(wo, wi, TransportMode::Radiance) * AbsCosTheta(wi);
        if (!f) return f;
        return f * ls->L *
               (Visibility(scene, sp.OffsetOrigin(ls->wi), ls->pLight, time, counts) /
                (chosen->pmf * ls->pdf));
    }

    template <typename BxDF, typename SamplerT>
    std::optional<BSDFSample> Scatter(const BxDF &bxdf, Vector3f wo, SamplerT *sampler) const {
        const float uc = sampler->Get1D();
        const Point2f u = sampler->Get2D();
        if (sampleBSDF) return bxdf.Sample_f(wo, uc, u, TransportMode::Radiance);
        const BxDFFlags flags = bxdf.Flags();
        const bool sphere = IsReflective(flags) && IsTransmissive(flags);
        Vector3f wi = sphere ? SampleUniformSphere(u) : SampleUniformHemisphere(u);
        if (!sphere && (wo.z < 0) == IsReflective(flags)) wi.z = -wi.z;
        return BSDFSample{bxdf.f(wo, wi, TransportMode::Radiance), wi,
                          sphere ? InvPi / 4 : InvPi / 2, BxDFFlags::Diffuse};
    }

    int maxDepth = 5;
    bool sampleLights = true, sampleBSDF = true;
    LightSampler lightSampler;
};

}  // namespace pbrt
