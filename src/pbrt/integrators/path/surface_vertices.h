#pragma once

#include "pbrt/integrators/path/emission.h"
#include "pbrt/integrators/path/path_batch.h"
#include "pbrt/integrators/path/surface_bsdfs.h"
#include "pbrt/lights/light_packet.h"
#include "pbrt/materials/materials.h"

namespace pbrt {

/// BSDFs as their materials make them; bench/sampling has one of its own, to compare with.
struct DefaultScattering {
    /// Input for one lane of BxDFPacket<BxDF<M>>.
    template <MaterialType M>
    static auto PacketInputAt(const M &material, const TextureEvalContext &ctx,
                              SampledWavelengths &lambda) {
        return pbrt::PacketInputAt(material, ctx, lambda);
    }
    template <MaterialType M>
    using BxDF = BxDFOf<M>;
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
/// kUniform: of uniform materials only.
template <typename M, bool kUniform, typename Scattering = DefaultScattering>
class SurfaceVertices {
  public:
    SurfaceVertices(const RenderScene &scene, const PathSettings &settings, PathBatch &batch,
                    const VertexNumbers &numbers)
        : scene(scene),
          settings(settings),
          batch(batch),
          numbers(numbers),
          bsdfs(scene.options.forceDiffuse) {}

    /// The paths at the first `count` of the given places in the queue; all places exist.
    void Shade(const UintX16 &places, int count) {
        at = places;
        lanes = FirstLanes(count);
        path = batch.queue->At(at);
        SurfaceAt();
        AddEmissions();
        const MaskX16 last = BitCast<int32_t>(path.depth) == settings.maxDepth;
        if (!kTraits.nullTransmission || scene.options.forceDiffuse) lanes &= ~BitsOf(last);
        if (lanes == 0) return;
        SetContexts();
        SetFrames();
        wo = frame.ToLocal(-path.d);
        lanes &= BitsOf(wo.z != 0.f);
        if constexpr (kTraits.nullTransmission) PassLastGaps(lanes & BitsOf(last));
        MakeBSDFs();
        if (nonSpecular != 0 && settings.strategy != LightStrategy::BSDFOnly) SampleLights();
        ScatterPaths();
        RussianRoulette();
        batch.next->Add(path, lanes);
    }

  private:
    static constexpr const MaterialTraits &kTraits = M::kTraits;

    uint32_t Slot(int i) const { return path.slot[i]; }
    const Geometry &GeometryAt(int i) const { return scene.geometries[hits.geometry[i]]; }
    const M &MaterialAt(int i) const {
        return *std::get_if<M>(&scene.materials.Data()[batch.material[at[i]]]);
    }

    void SurfaceAt() {
        hits = batch.HitsAt(at);
        const RayPacket rays{path.o, path.d, Broadcast<16>(Infinity), path.time};
        constexpr bool kWithTangents = !kUniform || kTraits.turnsFrame;
        sp = scene.SurfaceAt<kWithTangents>(hits, rays, lanes);
    }

    void AddEmissions() {
        ForEachLane(lanes, [&](int i) {
            const Geometry &geometry = GeometryAt(i);
            if (geometry.firstLight < 0) return;
            batch.L[Slot(i)] +=
                EmittedRadiance(scene, settings, path.At(i), geometry, hits.primitive[i],
                                Lane(sp, i), batch.lambda[Slot(i)]);
        });
    }

    const TextureEvalContext &ContextAt(int i) const { return contexts[kUniform ? 0 : size_t(i)]; }
    void SetContexts() {
        if constexpr (!kUniform) {
            scene.TextureContexts(sp, lanes, batch.clamped, &contexts);
            if (scene.materials.AnyBump()) TiltNormals();
        }
    }
    void TiltNormals() {
        ForEachLane(lanes, [&](int i) {
            const BumpMap *const bump = scene.materials.Data()[batch.material[at[i]]].bump.get();
            if (!bump) return;
            SurfaceInteraction one = Lane(sp, i);
            bump->Tilt(ContextAt(i), &one);
            SetLane(&sp.ns, i, one.ns);
            SetLane(&sp.dpdus, i, one.dpdus);
        });
    }

    void SetFrames() {
        if constexpr (kTraits.isotropic || (kUniform && !kTraits.turnsFrame)) {
            frame = FrameX16::FromZ(sp.ns);
        } else if constexpr (kTraits.fibre) {
            frame = sp.FibreFrame(path.d);
        } else {
            frame = sp.ShadingFrame();
            if constexpr (kTraits.turnsFrame) TurnFrames();
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
            const float gap = MaterialAt(i).NullTransmission(ContextAt(i), Lane(wo, i));
            if (gap == 0) return;
            path.beta[size_t(i)] *= gap;
            pass |= LaneBits(1) << i;
        });
        if (pass != 0) {
            PathPacket onward = path;
            onward.o = sp.OffsetOrigin(path.d);
            batch.next->Add(onward, pass);
        }
        lanes &= ~last;
    }

    void MakeBSDFs() {
        ForEachLane(lanes, [&](int i) {
            if (scene.options.forceDiffuse) [[unlikely]]
                bsdfs.SetDiffuse(i, MaterialAt(i).GetBxDF(ContextAt(i), batch.lambda[Slot(i)]),
                                 Lane(wo, i));
            else
                bsdfs.Set(i, Scattering::PacketInputAt(MaterialAt(i), ContextAt(i),
                                                       batch.lambda[Slot(i)]));
            if (settings.regularize && path.anyNonSpecular[i]) bsdfs.Regularize(i);
            const BxDFFlags flags = bsdfs.Flags(i);
            nonSpecular |= LaneBits(IsNonSpecular(flags)) << i;
            allSides |= LaneBits(IsTransmissive(flags)) << i;
        });
        litSide = Select(MaskOf(allSides), {}, frame.z * CopySign(1.f, wo.z));
    }

    void SampleLights() {
        const LightSampleContextX16 ctx{sp.p, litSide, path.time};
        LightLiSamples ls;
        const FloatX16 pmf = ChooseLights(ctx, &ls);
        const Vector3fX16 wi = frame.ToLocal(ls.wi);
        const LaneBits lit = ls.valid & nonSpecular & BitsOf((wi.z != 0.f) & (ls.pdf > 0.f));
        if (lit == 0) return;
        const BxDFValues values = bsdfs.Evaluate(wo, wi, lit);
        const FloatX16 lightPDF = pmf * ls.pdf;
        FloatX16 weight = Abs(wi.z) / lightPDF;
        if (settings.strategy == LightStrategy::Both)
            weight *= Select(MaskOf(ls.delta), 1.f, PowerHeuristic(lightPDF, values.pdf));
        std::array<SampledSpectrum, kPacketSize> gain;
        LaneBits some = 0;
        ForEachLane(lit, [&](int i) {
            const size_t k = size_t(i);
            gain[k] = path.beta[k] * values.f[k] * ls.L[k] * weight[i];
            some |= LaneBits(bool(gain[k])) << i;
        });
        batch.shadows.Add(path.slot, path.time, sp.OffsetOrigin(ls.wi), ls.pLight, gain, some);
    }

    /// Probabilities of the lights chosen; samples of them.
    FloatX16 ChooseLights(const LightSampleContextX16 &ctx, LightLiSamples *samples) const {
        FloatX16 pmf = Broadcast<16>(1.f);
        LightPacket lights{};
        if (const auto only = settings.lightSampler.OnlyLight()) {
            lights.fill(&scene.lights[size_t(*only)]);
        } else {
            const SampledLights chosen =
                settings.lightSampler.Sample(ctx, numbers.light, nonSpecular);
            pmf = chosen.pmf;
            ForEachLane(chosen.valid, [&](int i) {
                lights[size_t(i)] = &scene.lights[size_t(chosen.light[size_t(i)])];
            });
        }
        WavelengthPacket lambda;
        for (int i = 0; i < kPacketSize; ++i)
            lambda[size_t(i)] = &batch.lambda[Slot(i)];
        SampleLi(lights, ctx, numbers.lightPoint, lambda, nonSpecular, samples);
        return pmf;
    }

    /// Sets path to what follows; takes lanes that end.
    void ScatterPaths() {
        const BxDFSamples s = bsdfs.Sample(wo, numbers.lobe, numbers.direction, lanes);
        const FloatX16 weight = Abs(s.wi.z) / s.pdf;
        LaneBits some = 0;
        ForEachLane(s.valid & BitsOf((s.pdf != 0.f) & (s.wi.z != 0.f)), [&](int i) {
            path.beta[size_t(i)] *= s.f[size_t(i)] * weight[i];
            some |= LaneBits(bool(s.f[size_t(i)])) << i;
        });
        lanes &= some;
        const MaskX16 specular = MaskOf(s.specular), straight = MaskOf(s.nullTransmission);
        if (s.transmission != 0)
            path.etaScale *= Select(MaskOf(s.transmission), s.eta * s.eta, 1.f);
        path.anyNonSpecular |= Select(specular | straight, 0u, 1u);
        SpawnRay(frame.FromLocal(s.wi), Select(specular, 0.f, s.pdf), straight);
    }

    /// The next ray: into d, but where it passes a gap.
    void SpawnRay(const Vector3fX16 &d, const FloatX16 &pdf, const MaskX16 &straight) {
        path.d = Select(straight, path.d, d);
        path.o = sp.OffsetOrigin(path.d);
        path.p = Select(straight, path.p, sp.p);
        path.ns = Select(straight, path.ns, litSide);
        path.bsdfPDF = Select(straight, path.bsdfPDF, pdf);
        path.depth = Select(straight, path.depth, path.depth + 1u);
    }

    /// Russian roulette, from the second bounce on, where a path's importance falls below 2/3. At
    /// 1, as is usual, an image takes 4 % (hair) to 20 % less time, but has 1.2 (a mesh under a
    /// sky) to 1.4 times the squared error; at 1/2 and below nothing more is gained.
    static constexpr float kSafeImportance = 2.f / 3;
    void RussianRoulette() {
        // All at once: a branch for each path would often be mispredicted (2 % of rendering time).
        const auto brightest =
            FloatX16::Generate([&](int i) { return path.beta[size_t(i)].MaxComponentValue(); });
        const FloatX16 importance = brightest * path.etaScale * (1 / kSafeImportance);
        const LaneBits positive = BitsOf(importance > 0);
        const LaneBits safe = positive & BitsOf((importance >= 1) | (path.depth <= 1u));
        const LaneBits ends = ~positive | (BitsOf(numbers.roulette >= importance) & ~safe);
        lanes &= ~ends;
        ForEachLane(lanes & ~safe, [&](int i) { path.beta[size_t(i)] *= 1 / importance[i]; });
    }

    const RenderScene &scene;
    const PathSettings &settings;
    PathBatch &batch;
    const VertexNumbers &numbers;
    UintX16 at;
    LaneBits lanes = 0;  ///< of the paths that still are to be worked on
    LaneBits nonSpecular = 0;
    LaneBits allSides = 0;  ///< receive light from both sides of the surface, or from behind
    Normal3fX16 litSide;    ///< shading normal on the side of wo; 0: allSides
    PathPacket path;
    HitPacket hits;
    SurfaceInteractionX16 sp;
    std::array<TextureEvalContext, kUniform ? 1 : kPacketSize> contexts;
    FrameX16 frame;
    Vector3fX16 wo;
    SurfacePacketBSDF<typename Scattering::template BxDF<M>> bsdfs;
};

}  // namespace pbrt
