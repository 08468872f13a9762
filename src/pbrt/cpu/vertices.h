#pragma once

#include "pbrt/bxdfs/feather_lanes.h"
#include "pbrt/cpu/emission.h"
#include "pbrt/cpu/path_batch.h"
#include "pbrt/cpu/surface_lanes.h"
#include "pbrt/lights/light_packet.h"

namespace pbrt {

/// BSDFs as their materials make them, or what BxDFLanes makes them of; bench/sampling passes one
/// of its own, to compare with.
struct BSDFAsItIs {
    template <typename M>
    static auto At(const M &material, const TextureEvalContext &ctx, SampledWavelengths &lambda) {
        if constexpr (requires { material.GetSurface(ctx, lambda); })
            return material.GetSurface(ctx, lambda);
        else
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
        : world(world), batch(batch), numbers(numbers), bsdfs(world.options.forceDiffuse) {}

    /// The paths at the first `count` of the given places in the queue; all places exist.
    void Meet(const WideUint &places, int count) {
        at = places;
        lanes = FirstLanes(count);
        path = batch.queue->At(at);
        Interact();
        AddEmissions();
        const WideMask last = std::bit_cast<WideInt>(path.depth) == world.path.maxDepth;
        if (!PassesLight<M> || world.options.forceDiffuse) lanes &= ~BitsOf(last);
        if (lanes == 0) return;
        SetContexts();
        SetFrames();
        wo = frame.ToLocal(-path.d);
        lanes &= BitsOf(wo.z != 0.f);
        if constexpr (PassesLight<M>) PassLastGaps(lanes & BitsOf(last));
        MakeBSDFs();
        if (nonSpecular != 0 && world.path.strategy != LightStrategy::BSDFOnly) SampleLights();
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
        constexpr bool kWithTangents = !kPlain || TurnsFrame<M>;
        sp = world.Interact<kWithTangents>(hits, rays, lanes);
    }

    void AddEmissions() {
        ForEachLane(lanes, [&](int i) {
            const Geometry &geometry = GeometryAt(i);
            if (geometry.firstLight < 0) return;
            batch.L[Slot(i)] += LightOfSurface(world, path.At(i), geometry, hits.primitive[i],
                                               Lane(sp, i), batch.lambda[Slot(i)]);
        });
    }

    const TextureEvalContext &ContextAt(int i) const { return contexts[kPlain ? 0 : size_t(i)]; }
    void SetContexts() {
        if constexpr (!kPlain) world.TextureContexts(sp, lanes, &contexts);
    }

    void SetFrames() {
        if constexpr (kIsotropic || (kPlain && !TurnsFrame<M>)) {
            frame = WideFrame::FromZ(sp.ns);
        } else if constexpr (IsFibre<M>) {
            frame = sp.FibreFrame(path.d);
        } else {
            frame = sp.ShadingFrame();
            if constexpr (TurnsFrame<M>) TurnFrames();
        }
    }
    void TurnFrames() {
        ForEachLane(lanes, [&](int i) {
            if (!MaterialAt(i).TurnsFrame()) return;
            const Frame straight{Lane(frame.x, i), Lane(frame.y, i), Lane(frame.z, i)};
            SetLane(&frame, i, MaterialAt(i).TurnFrame(straight, ContextAt(i)));
        });
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
            if (world.options.forceDiffuse) [[unlikely]]
                bsdfs.SetDiffuse(i, MaterialAt(i).GetBxDF(ContextAt(i), batch.lambda[Slot(i)]),
                                 Lane(wo, i));
            else
                bsdfs.Set(i, Scattering::At(MaterialAt(i), ContextAt(i), batch.lambda[Slot(i)]));
            if (world.path.regularize && path.anyNonSpecular[i]) bsdfs.Regularize(i);
            const BxDFFlags flags = bsdfs.Flags(i);
            nonSpecular |= LaneBits(IsNonSpecular(flags)) << i;
            allSides |= LaneBits(IsTransmissive(flags)) << i;
        });
        litSide = Select(MaskOf(allSides), {}, frame.z * CopySign(1.f, wo.z));
    }

    void SampleLights() {
        const WideLightSampleContext ctx{sp.p, litSide};
        LightLiSamples ls;
        const WideFloat pmf = ChooseLights(ctx, &ls);
        const WideVector3f wi = frame.ToLocal(ls.wi);
        const LaneBits lit = ls.valid & nonSpecular & BitsOf((wi.z != 0.f) & (ls.pdf > 0.f));
        if (lit == 0) return;
        const BxDFValues values = bsdfs.Evaluate(wo, wi, lit);
        const WideFloat lightPDF = pmf * ls.pdf;
        WideFloat weight = Abs(wi.z) / lightPDF;
        if (world.path.strategy == LightStrategy::Both)
            weight *= Select(MaskOf(ls.delta), 1.f, PowerHeuristic(lightPDF, values.pdf));
        std::array<SampledSpectrum, kWide> gain;
        LaneBits some = 0;
        ForEachLane(lit, [&](int i) {
            const size_t k = size_t(i);
            gain[k] = path.beta[k] * values.f[k] * ls.L[k] * weight[i];
            some |= LaneBits(bool(gain[k])) << i;
        });
        batch.shadows.Add(path.slot, path.time, sp.OffsetOrigin(ls.wi), ls.pLight, gain, some);
    }

    /// Probabilities of the lights chosen; samples of them.
    WideFloat ChooseLights(const WideLightSampleContext &ctx, LightLiSamples *samples) const {
        WideFloat pmf = Broadcast16(1.f);
        LightLanes lights{};
        if (const auto only = world.lightSampler.OnlyLight()) {
            lights.fill(&world.lights[size_t(*only)]);
        } else {
            const SampledLights chosen = world.lightSampler.Sample(ctx, numbers.light, nonSpecular);
            pmf = chosen.pmf;
            ForEachLane(chosen.valid, [&](int i) {
                lights[size_t(i)] = &world.lights[size_t(chosen.light[size_t(i)])];
            });
        }
        WavelengthLanes lambda;
        for (int i = 0; i < kWide; ++i)
            lambda[size_t(i)] = &batch.lambda[Slot(i)];
        SampleLi(lights, ctx, numbers.lightPoint, lambda, nonSpecular, samples);
        return pmf;
    }

    /// Sets path to what follows; takes lanes that end.
    void ScatterPaths() {
        const BxDFSamples s = bsdfs.Sample(wo, numbers.lobe, numbers.direction, lanes);
        const WideFloat weight = Abs(s.wi.z) / s.pdf;
        LaneBits some = 0;
        ForEachLane(s.valid & BitsOf((s.pdf != 0.f) & (s.wi.z != 0.f)), [&](int i) {
            path.beta[size_t(i)] *= s.f[size_t(i)] * weight[i];
            some |= LaneBits(bool(s.f[size_t(i)])) << i;
        });
        lanes &= some;
        const WideMask specular = MaskOf(s.specular), straight = MaskOf(s.gap);
        if (s.transmission != 0)
            path.etaScale *= Select(MaskOf(s.transmission), s.eta * s.eta, 1.f);
        path.anyNonSpecular |= std::bit_cast<WideUint>(~(specular | straight) & 1);
        Turn(frame.FromLocal(s.wi), Select(specular, 0.f, s.pdf), straight);
    }

    /// The next ray: into d, but where it passes a gap.
    void Turn(const WideVector3f &d, const WideFloat &pdf, const WideMask &straight) {
        path.d = Select(straight, path.d, d);
        path.o = sp.OffsetOrigin(path.d);
        path.p = Select(straight, path.p, sp.p);
        path.ns = Select(straight, path.ns, litSide);
        path.bsdfPDF = Select(straight, path.bsdfPDF, pdf);
        path.depth = Select(straight, path.depth, path.depth + 1u);
    }

    /// Russian roulette, from the second bounce on, where a path's importance falls below 2/3. At
    /// 1, as is usual, a picture takes 4 % (hair) to 20 % less time, but has 1.2 (a mesh under a
    /// sky) to 1.4 times the squared error; at 1/2 and below nothing more is gained.
    static constexpr float kSafeImportance = 2.f / 3;
    void Survive() {
        ForEachLane(lanes, [&](int i) {
            SampledSpectrum &beta = path.beta[size_t(i)];
            const float importance =
                (beta * path.etaScale[i]).MaxComponentValue() * (1 / kSafeImportance);
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
    LaneBits lanes = 0;  ///< of the paths that still are to be worked on
    LaneBits nonSpecular = 0;
    LaneBits allSides = 0;  ///< receive light from both sides of the surface, or from behind
    WideNormal3f litSide;   ///< shading normal on the side of wo; 0: allSides
    PathLanes path;
    HitPacket hits;
    SurfacePoints sp;
    std::array<TextureEvalContext, kPlain ? 1 : kWide> contexts;
    WideFrame frame;
    WideVector3f wo;
    SurfaceLanes<BxDF> bsdfs;
};

}  // namespace pbrt
