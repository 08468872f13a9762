#pragma once

#include "pbrt/bxdfs/bxdf.h"
#include "pbrt/cpu/shading_frame.h"
#include "pbrt/cpu/world.h"

namespace pbrt {

/// Rays traced; each thread counts its own.
struct RayCounts {
    int64_t closest = 0, shadow = 0;
    RayCounts &operator+=(const RayCounts &b) {
        return closest += b.closest, shadow += b.shadow, *this;
    }
};

inline float PowerHeuristic(float f, float g) {
    if (f > 1e18f) return 1;
    return f * f / (f * f + g * g);
}

/// BSDFs as their materials make them. bench/sampling passes one of its own, to compare with.
struct BSDFAsItIs {
    template <typename M>
    static auto At(const M &material, const TextureEvalContext &ctx, SampledWavelengths &lambda) {
        return material.GetBxDF(ctx, lambda);
    }
};

/// Follows one path from the camera and gathers radiance: multiple importance sampling of lights
/// and BSDF with the power heuristic, Russian roulette after the first bounce.
///
/// Gaps: a path that passes a gap goes straight on with the weights of the vertex it came from and
/// does not count as a bounce; shadow rays take each surface's gap fraction. Both estimate the same
/// light, so the weights of the two ways still add to 1.
template <typename SamplerT, typename Scattering = BSDFAsItIs>
class PathTracer {
  public:
    PathTracer(const World &world, SamplerT &sampler, RayCounts &rays)
        : world(world), settings(world.path), sampler(sampler), rays(rays) {}

    /// Radiance along `cameraRay`; the wavelengths may lose the secondary ones.
    SampledSpectrum Li(const Ray &cameraRay, SampledWavelengths &wavelengths) {
        lambda = &wavelengths;
        ray = cameraRay;
        L = SampledSpectrum(0);
        beta = SampledSpectrum(1);
        depth = 0;
        etaScale = 1;
        bsdfPDF = 0;
        anyNonSpecular = false;
        while (Step()) {
        }
        return L;
    }

  private:
    bool Step() {
        Hit hit;
        ++rays.closest;
        if (!world.accel->Intersect(ray, &hit)) {
            AddInfiniteLights();
            return false;
        }
        const Geometry &geometry = world.geometries[hit.geometry];
        if (depth == settings.maxDepth && geometry.firstLight < 0 && !geometry.passesLight)
            return false;
        const SurfacePoint sp = world.Interact(hit, ray);
        if (geometry.firstLight >= 0) AddEmission(geometry, hit, sp);
        return std::visit([&](const auto &material) { return Scatter(material, sp); },
                          world.MaterialMet(geometry.material, sp, ray.d));
    }

    /// Weight of light found by following the BSDF, `lightPDF` being what light sampling would have
    /// drawn it with from the last vertex.
    float WeightOfFound(float lightPDF) const {
        if (bsdfPDF == 0 || lightPDF == 0) return 1;  // camera, delta lobe; or not light-sampled
        switch (settings.strategy) {
            case LightStrategy::LightsOnly:
                return 0;
            case LightStrategy::BSDFOnly:
                return 1;
            default:
                return PowerHeuristic(bsdfPDF, lightPDF);
        }
    }

    void AddInfiniteLights() {
        for (int i : world.infiniteLights) {
            const Light &light = world.lights[i];
            const SampledSpectrum Le = pbrt::Le(light, ray, *lambda);
            const float lightPDF =
                bsdfPDF == 0 ? 0
                             : world.lightSampler.PMF(previous, i) * PDF_Li(light, previous, ray.d);
            L += beta * Le * WeightOfFound(lightPDF);
        }
    }

    void AddEmission(const Geometry &geometry, const Hit &hit, const SurfacePoint &sp) {
        const int index = World::LightOf(geometry, hit);
        const SampledSpectrum Le = pbrt::L(world.lights[index], sp.p, sp.n, sp.uv, -ray.d, *lambda);
        if (!Le) return;
        float lightPDF = 0;
        if (bsdfPDF != 0)
            lightPDF = world.lightSampler.PMF(previous, index) *
                       PDF_Hit(world.lights[index], previous, ray.d, sp.p, sp.n);
        L += beta * Le * WeightOfFound(lightPDF);
    }

    /// One vertex; false where the path ends.
    template <typename M>
    bool Scatter(const M &material, const SurfacePoint &sp) {
        if (depth == settings.maxDepth && !PassesLight<M>) return false;
        const TextureEvalContext ctx = world.TextureContext(sp);
        const Frame frame = FrameFor(material, sp, ctx);
        const Vector3f wo = frame.ToLocal(-ray.d);
        if (wo.z == 0) return false;
        if constexpr (PassesLight<M>)
            if (depth == settings.maxDepth) return PassLastGap(sp, material.GapFraction(ctx, wo));

        auto bsdf = Scattering::At(material, ctx, *lambda);
        if (settings.regularize && anyNonSpecular) bsdf.Regularize();
        if (IsNonSpecular(bsdf.Flags()) && settings.strategy != LightStrategy::BSDFOnly)
            L += beta * SampleLights(bsdf, sp, frame, wo);
        const float uc = sampler.Get1D();
        const auto s = bsdf.Sample_f(wo, uc, sampler.Get2D(), TransportMode::Radiance);
        if (!s || s->pdf == 0 || s->wi.z == 0 || !s->f) return false;
        return Continue(*s, bsdf.Flags(), sp, frame);
    }

    /// After the last scattering only straight passage is left: take its expectation.
    bool PassLastGap(const SurfacePoint &sp, float gap) {
        if (gap == 0) return false;
        beta *= gap;
        ray.o = sp.OffsetOrigin(ray.d);
        return true;
    }

    bool Continue(const BSDFSample &s, BxDFFlags flags, const SurfacePoint &sp,
                  const Frame &frame) {
        beta *= s.f * (std::abs(s.wi.z) / s.pdf);
        if (Has(s.flags, BxDFFlags::Gap)) {
            ray.o = sp.OffsetOrigin(ray.d);
            return Survives();
        }
        const bool specular = IsSpecular(s.flags);
        anyNonSpecular |= !specular;
        if (Has(s.flags, BxDFFlags::Transmission)) etaScale *= Sqr(s.eta);
        const Vector3f d = frame.FromLocal(s.wi);
        bsdfPDF = specular ? 0 : s.pdf;
        previous = ContextAt(sp, flags);
        ray.o = sp.OffsetOrigin(d);
        ray.d = d;
        ++depth;
        return Survives();
    }

    /// Russian roulette, from the second bounce on.
    bool Survives() {
        const float importance = (beta * etaScale).MaxComponentValue();
        if (!(importance > 0)) return false;
        if (importance >= 1 || depth <= 1) return true;
        if (sampler.Get1D() >= importance) return false;
        beta *= 1 / importance;
        return true;
    }

    static LightSampleContext ContextAt(const SurfacePoint &sp, BxDFFlags flags) {
        if (IsReflective(flags) && IsTransmissive(flags)) return {sp.p, {}, {}};
        return {sp.p, sp.n, sp.ns};
    }

    template <typename B>
    SampledSpectrum SampleLights(const B &bsdf, const SurfacePoint &sp, const Frame &frame,
                                 Vector3f wo) {
        const LightSampleContext ctx = ContextAt(sp, bsdf.Flags());
        const float uLight = sampler.Get1D();
        const Point2f u = sampler.Get2D();
        const auto chosen = world.lightSampler.Sample(ctx, uLight);
        if (!chosen) return SampledSpectrum(0);
        const auto ls = SampleLi(world.lights[chosen->light], ctx, u, *lambda);
        if (!ls || !(ls->pdf > 0)) return SampledSpectrum(0);
        const Vector3f wi = frame.ToLocal(ls->wi);
        if (wi.z == 0) return SampledSpectrum(0);
        SampledSpectrum f = bsdf.f(wo, wi, TransportMode::Radiance) * std::abs(wi.z);
        if (!f) return f;
        const float visible = Transmittance(sp.OffsetOrigin(ls->wi), ls->pLight);
        if (visible == 0) return SampledSpectrum(0);
        const float lightPDF = chosen->pmf * ls->pdf;
        float weight = visible / lightPDF;
        if (!ls->delta && settings.strategy == LightStrategy::Both)
            weight *= PowerHeuristic(lightPDF, bsdf.PDF(wo, wi, TransportMode::Radiance));
        return f * ls->L * weight;
    }

    /// Fraction of light that passes between two points.
    float Transmittance(Point3f from, Point3f to) {
        ++rays.shadow;
        const Ray shadow{from, to - from, 1 - 1e-4f, ray.time};
        if (!world.accel->HasGaps()) return world.accel->Occluded(shadow) ? 0 : 1;
        struct Gaps final : GapTransmittance {
            const World &world;
            explicit Gaps(const World &world) : world(world) {}
            float operator()(const Hit &hit, const Ray &ray) const override {
                return GapFractionAt(world, hit, ray);
            }
        };
        return world.accel->Transmittance(shadow, Gaps(world));
    }

  public:
    /// Share of light along `ray` that passes the surface it meets at `hit`.
    static float GapFractionAt(const World &world, const Hit &hit, const Ray &ray) {
        const SurfacePoint sp = world.InteractLightly(hit, ray);
        return GapFractionOf(world, world.geometries[hit.geometry].material, sp, ray.d);
    }

  private:
    /// Of a mix: what is expected of its choice.
    static float GapFractionOf(const World &world, MaterialId id, const SurfacePoint &sp,
                               Vector3f d) {
        const MixMaterial *const mix = world.AsMix(id);
        if (!mix) {
            return std::visit([&](const auto &m) { return GapFractionOf(world, m, sp, d); },
                              world.materials[id]);
        }
        const float share = mix->amount.Evaluate(world.TextureContext(sp));
        float gap = 0;
        if (share < 1) gap += (1 - share) * GapFractionOf(world, mix->materials[0], sp, d);
        if (share > 0) gap += share * GapFractionOf(world, mix->materials[1], sp, d);
        return gap;
    }
    template <typename M>
    static float GapFractionOf(const World &world, const M &material, const SurfacePoint &sp,
                               Vector3f d) {
        if constexpr (PassesLight<M>) {
            const TextureEvalContext ctx = world.TextureContext(sp);
            const Frame frame = material.TurnFrame(sp.ShadingFrame(), ctx);
            return material.GapFraction(ctx, frame.ToLocal(Normalize(-d)));
        } else {
            return 0;
        }
    }

    const World &world;
    const PathSettings settings;
    SamplerT &sampler;
    RayCounts &rays;
    SampledWavelengths *lambda = nullptr;

    Ray ray;
    SampledSpectrum L, beta;
    int depth = 0;
    float etaScale = 1;
    float bsdfPDF = 0;  ///< of ray.d at `previous`; 0: from the camera or a delta lobe
    LightSampleContext previous;
    bool anyNonSpecular = false;
};

}  // namespace pbrt
