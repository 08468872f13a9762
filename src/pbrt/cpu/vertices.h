#pragma once

#include "pbrt/bxdfs/bxdf.h"
#include "pbrt/cpu/emission.h"
#include "pbrt/cpu/path_batch.h"
#include "pbrt/cpu/shading_frame.h"

namespace pbrt {

/// BSDFs as their materials make them. bench/sampling passes one of its own, to compare with.
struct BSDFAsItIs {
    template <typename M>
    static auto At(const M &material, const TextureEvalContext &ctx, SampledWavelengths &lambda) {
        return material.GetBxDF(ctx, lambda);
    }
};

/// One vertex of each of up to sixteen paths that meet surfaces of material type M: light that it
/// gives, light that it may receive, and where the paths go on. Multiple importance sampling of
/// lights and BSDF with the power heuristic, Russian roulette after the first bounce.
///
/// Gaps: a path that passes a gap goes straight on with the weights of the vertex it came from and
/// does not count as a bounce; shadow rays take each surface's gap fraction. Both estimate the same
/// light, so the weights of the two ways still add to 1.
///
/// Geometry is sixteen wide; spectra, four wide already, and BSDFs go path by path, as does what
/// few of the paths need.
///
/// kPlain: of plain materials only.
template <typename M, bool kPlain, typename Scattering = BSDFAsItIs>
class Vertices {
  public:
    Vertices(const World &world, PathBatch &batch, const VertexNumbers &numbers)
        : world(world), batch(batch), numbers(numbers) {}

    /// The paths at the first `count` of the given places in the queue; all places exist.
    void Meet(const WideUint &places, int count) {
        at = places;
        lanes = FirstLanes(count);
        path = batch.queue->At(at);
        Interact();
        AddEmissions();
        const WideMask last = std::bit_cast<WideInt>(path.depth) == world.path.maxDepth;
        if constexpr (!PassesLight<M>) lanes &= ~BitsOf(last);
        if (lanes == 0) return;
        SetFrames();
        wo = frame.ToLocal(-path.d);
        lanes &= BitsOf(wo.z != 0.f);
        if constexpr (PassesLight<M>) PassLastGaps(lanes & BitsOf(last));
        MakeBSDFs();
        if (world.path.strategy != LightStrategy::BSDFOnly) SampleLights();
        ScatterPaths();
        Survive();
        batch.next->Add(path, lanes);
    }

  private:
    using BxDF = decltype(Scattering::At(std::declval<const M &>(),
                                         std::declval<const TextureEvalContext &>(),
                                         std::declval<SampledWavelengths &>()));
    static constexpr bool kIsotropic = requires { M::kIsotropic; };

    uint32_t Slot(int i) const { return path.slot[i]; }
    const Geometry &GeometryAt(int i) const { return world.geometries[hits.geometry[i]]; }
    const M &MaterialAt(int i) const {
        return *std::get_if<M>(&world.materials[size_t(batch.material[at[i]])]);
    }

    void Interact() {
        hits = batch.HitsAt(at);
        const RayPacket rays{path.o, path.d, Broadcast16(Infinity), path.time};
        sp = world.Interact<!kPlain>(hits, rays, lanes);
    }

    void AddEmissions() {
        ForEachLane(lanes, [&](int i) {
            const Geometry &geometry = GeometryAt(i);
            if (geometry.firstLight < 0) return;
            batch.L[Slot(i)] += LightOfSurface(world, path.At(i), geometry, hits.primitive[i],
                                               Lane(sp, i), batch.lambda[Slot(i)]);
        });
    }

    static bool ReceivesFromAllSides(BxDFFlags flags) {
        return IsReflective(flags) && IsTransmissive(flags);
    }
    TextureEvalContext ContextAt(int i) const {
        return kPlain ? TextureEvalContext() : world.TextureContext(Lane(sp, i));
    }

    void SetFrames() {
        if constexpr (kPlain || kIsotropic) {
            frame = WideFrame::FromZ(sp.ns);
        } else {
            ForEachLane(lanes, [&](int i) {
                SetLane(&frame, i, FrameFor(MaterialAt(i), Lane(sp, i), ContextAt(i)));
            });
        }
    }

    /// After the last scattering only straight passage is left: take its expectation.
    void PassLastGaps(LaneBits last) {
        LaneBits pass = 0;
        ForEachLane(last, [&](int i) {
            const float gap = MaterialAt(i).GapFraction(ContextAt(i), Lane(wo, i));
            if (gap == 0) return;
            path.beta[size_t(i)] *= gap;
            pass |= LaneBits(1) << i;
        });
        if (pass != 0) {
            PathLanes onward = path;
            onward.o = sp.OffsetOrigin(path.d);
            batch.next->Add(onward, pass);
        }
        lanes &= ~last;
    }

    void MakeBSDFs() {
        ForEachLane(lanes, [&](int i) {
            BxDF &bsdf = bsdfs[size_t(i)].emplace(
                Scattering::At(MaterialAt(i), ContextAt(i), batch.lambda[Slot(i)]));
            if (world.path.regularize && path.anyNonSpecular[i]) bsdf.Regularize();
        });
    }

    void SampleLights() {
        LaneBits nonSpecular = 0;
        WideLightSampleContext ctx{sp.p, sp.n, sp.ns};
        ForEachLane(lanes, [&](int i) {
            const BxDFFlags flags = bsdfs[size_t(i)]->Flags();
            if (!IsNonSpecular(flags)) return;
            nonSpecular |= LaneBits(1) << i;
            if (ReceivesFromAllSides(flags)) ctx.ForgetSide(i);
        });
        if (nonSpecular == 0) return;
        LightLiSamples ls;
        const WideFloat pmf = ChooseLights(ctx, nonSpecular, &ls);
        const WideVector3f wi = frame.ToLocal(ls.wi);
        const LaneBits lit = ls.valid & BitsOf((wi.z != 0.f) & (ls.pdf > 0.f));
        const WideFloat lightPDF = pmf * ls.pdf, absCos = Abs(wi.z);
        std::array<SampledSpectrum, kWide> gain;
        LaneBits some = 0;
        ForEachLane(lit, [&](int i) {
            const auto [f, pdf] = Evaluate(*bsdfs[size_t(i)], Lane(wo, i), Lane(wi, i));
            if (!f) return;
            float weight = absCos[i] / lightPDF[i];
            if (!(ls.delta >> i & 1) && world.path.strategy == LightStrategy::Both)
                weight *= PowerHeuristic(lightPDF[i], pdf);
            gain[size_t(i)] = path.beta[size_t(i)] * f * ls.L[size_t(i)] * weight;
            if (gain[size_t(i)]) some |= LaneBits(1) << i;
        });
        batch.shadows.Add(path.slot, path.time, sp.OffsetOrigin(ls.wi), ls.pLight, gain, some);
    }

    /// Probabilities of the lights chosen; samples of them.
    WideFloat ChooseLights(const WideLightSampleContext &ctx, LaneBits receivers,
                           LightLiSamples *samples) const {
        WideFloat pmf = Broadcast16(1.f);
        std::array<const Light *, kWide> lights{};
        if (const auto only = world.lightSampler.OnlyLight()) {
            lights.fill(&world.lights[size_t(*only)]);
        } else {
            ForEachLane(receivers, [&](int i) {
                const auto chosen = world.lightSampler.Sample(ctx.At(i), numbers.light[i]);
                if (!chosen) return;
                pmf[i] = chosen->pmf;
                lights[size_t(i)] = &world.lights[size_t(chosen->light)];
            });
        }
        std::array<const SampledWavelengths *, kWide> lambda{};
        ForEachLane(receivers, [&](int i) { lambda[size_t(i)] = &batch.lambda[Slot(i)]; });
        ForEachLane(receivers, [&](int i) {
            const Light *const light = lights[size_t(i)];
            if (!light) return;
            if (const auto s =
                    SampleLi(*light, ctx.At(i), Lane(numbers.lightPoint, i), *lambda[size_t(i)]))
                samples->Set(i, *s);
        });
        return pmf;
    }

    struct Value {
        SampledSpectrum f;
        float pdf;
    };
    static Value Evaluate(const BxDF &bsdf, Vector3f wo, Vector3f wi) {
        return {bsdf.f(wo, wi, TransportMode::Radiance), bsdf.PDF(wo, wi, TransportMode::Radiance)};
    }

    /// Sets path to what follows; takes lanes that end.
    void ScatterPaths() {
        WideVector3f wi{};
        WideFloat pdf{};
        LaneBits gone = 0, straight = 0;
        ForEachLane(lanes, [&](int i) {
            const auto s = bsdfs[size_t(i)]->Sample_f(
                Lane(wo, i), numbers.lobe[i], Lane(numbers.direction, i), TransportMode::Radiance);
            const LaneBits bit = LaneBits(1) << i;
            if (!s || s->pdf == 0 || s->wi.z == 0 || !s->f) {
                gone |= bit;
                return;
            }
            path.beta[size_t(i)] *= s->f * (std::abs(s->wi.z) / s->pdf);
            if (Has(s->flags, BxDFFlags::Gap)) {
                straight |= bit;
                return;
            }
            SetLane(&wi, i, s->wi);
            pdf[i] = IsSpecular(s->flags) ? 0 : s->pdf;
            if (!IsSpecular(s->flags)) path.anyNonSpecular[i] = 1;
            if (Has(s->flags, BxDFFlags::Transmission)) path.etaScale[i] *= Sqr(s->eta);
            if (ReceivesFromAllSides(bsdfs[size_t(i)]->Flags())) allSides |= bit;
        });
        lanes &= ~gone;
        Turn(frame.FromLocal(wi), pdf, MaskOf(straight));
    }

    /// The next ray: into d, but where it passes a gap.
    void Turn(const WideVector3f &d, const WideFloat &pdf, const WideMask &straight) {
        path.d = Select(straight, path.d, d);
        path.o = sp.OffsetOrigin(path.d);
        const WideNormal3f none{};
        const WideMask sided = ~MaskOf(allSides);
        path.p = Select(straight, path.p, sp.p);
        path.n = Select(straight, path.n, Select(sided, sp.n, none));
        path.ns = Select(straight, path.ns, Select(sided, sp.ns, none));
        path.bsdfPDF = Select(straight, path.bsdfPDF, pdf);
        path.depth = Select(straight, path.depth, path.depth + 1u);
    }

    /// Russian roulette, from the second bounce on.
    void Survive() {
        ForEachLane(lanes, [&](int i) {
            SampledSpectrum &beta = path.beta[size_t(i)];
            const float importance = (beta * path.etaScale[i]).MaxComponentValue();
            if (importance > 0 && (importance >= 1 || path.depth[i] <= 1)) return;
            if (!(importance > 0) || numbers.roulette[i] >= importance)
                lanes &= ~(LaneBits(1) << i);
            else
                beta *= 1 / importance;
        });
    }

    const World &world;
    PathBatch &batch;
    const VertexNumbers &numbers;
    WideUint at;
    LaneBits lanes = 0;     ///< of the paths that still are to be worked on
    LaneBits allSides = 0;  ///< receive light from both sides of the surface
    PathLanes path;
    HitPacket hits;
    SurfacePoints sp;
    WideFrame frame;
    WideVector3f wo;
    std::array<std::optional<BxDF>, kWide> bsdfs;
};

}  // namespace pbrt
