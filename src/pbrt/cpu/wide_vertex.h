#pragma once

#include "pbrt/cpu/path_batch.h"
#include "pbrt/cpu/vertex.h"

namespace pbrt {

/// Sixteen of what a light gives; see LightLiSample.
struct LightLiSamples {
    std::array<SampledSpectrum, kWide> L;
    WideVector3f wi;
    WideFloat pdf;
    WidePoint3f pLight;
    LaneBits valid = 0, delta = 0;
};

/// One vertex of up to sixteen paths that meet matt surfaces: what PathVertex does for one.
/// Geometry is sixteen wide; spectra, four wide already, go path by path, as does what few of the
/// paths need.
template <typename SamplerT>
class WideVertex {
  public:
    WideVertex(const World &world, PathBatch &batch, VertexDraws<SamplerT> &draws)
        : world(world), batch(batch), draws(draws) {}

    /// `places` in the queue and slots of the paths, the first `count`; all lanes are readable.
    void Meet(const WideUint &places, const WideUint &slots, int count) {
        at = places;
        slot = slots;
        lanes = FirstLanes(count);
        ray = batch.queue->RaysAt(at);
        hits = batch.HitsAt(at);
        Interact();
        AddEmissions();
        depth = Gather(&batch.queue->depth[0], at);
        lanes &= BitsOf(std::bit_cast<WideInt>(depth) != world.path.maxDepth);
        if (lanes == 0) return;
        const WideFloat side = -Dot(ns, ray.d);
        lanes &= BitsOf(side != 0.f);
        facing = CopySign(1.f, side);
        ForEachLane(lanes, [&](int i) { beta[size_t(i)] = ScatteredBeta(i); });
        if (world.path.strategy != LightStrategy::BSDFOnly) SampleLights();
        Continue();
    }

  private:
    void Interact() {
        ForEachLane(lanes, [&](int i) {
            const Hit hit{hits.t[i],        hits.u[i],         hits.v[i],
                          hits.geometry[i], hits.primitive[i], hits.instance[i]};
            const SurfacePoint sp = world.Interact(hit, ray.At(i));
            SetLane(&p, i, sp.p);
            SetLane(&pError, i, sp.pError);
            SetLane(&n, i, sp.n);
            SetLane(&ns, i, sp.ns);
        });
    }

    void AddEmissions() {
        ForEachLane(lanes, [&](int i) {
            const Geometry &geometry = world.geometries[hits.geometry[i]];
            if (geometry.firstLight < 0) return;
            PathState path = batch.queue->At(int(at[i]));
            const Hit hit{hits.t[i],        hits.u[i],         hits.v[i],
                          hits.geometry[i], hits.primitive[i], hits.instance[i]};
            ShadowTest none;
            PathVertex<> vertex(world, path, batch.lambda[slot[i]], batch.L[slot[i]], none);
            vertex.AddEmission(geometry, hit, world.Interact(hit, path.ray));
        });
    }

    /// beta times the reflectance.
    SampledSpectrum ScatteredBeta(int i) const {
        const auto &material =
            *std::get_if<DiffuseMaterial>(&world.materials[size_t(
                world.geometries[hits.geometry[i]].material)]);
        return batch.queue->beta[at[i]] *
               material.reflectance.Constant().Sample(batch.lambda[slot[i]]);
    }

    void SampleLights() {
        LightLiSamples ls;
        const WideFloat choice = draws.Light();
        const WidePoint2f u = draws.LightPoint();
        WideFloat pmf{};
        ForEachLane(lanes, [&](int i) {
            const LightSampleContext ctx{Lane(p, i), Lane(n, i), Lane(ns, i)};
            const auto chosen = world.lightSampler.Sample(ctx, choice[i]);
            if (!chosen) return;
            const auto s = SampleLi(world.lights[size_t(chosen->light)], ctx, {u.x[i], u.y[i]},
                                    batch.lambda[slot[i]]);
            if (!s || !(s->pdf > 0)) return;
            ls.valid |= LaneBits(1) << i;
            if (s->delta) ls.delta |= LaneBits(1) << i;
            pmf[i] = chosen->pmf;
            ls.L[size_t(i)] = s->L;
            SetLane(&ls.wi, i, s->wi);
            SetLane(&ls.pLight, i, s->pLight);
            ls.pdf[i] = s->pdf;
        });
        const WideFloat cosine = Dot(ns, ls.wi) * facing;
        const LaneBits lit = ls.valid & lanes & BitsOf(cosine > 0.f);
        if (lit == 0) return;
        const WideFloat lightPDF = pmf * ls.pdf, pdf = cosine * InvPi;
        WideFloat weight = pdf / lightPDF;
        if (world.path.strategy == LightStrategy::Both) {
            const WideFloat heuristic =
                lightPDF * lightPDF / (lightPDF * lightPDF + pdf * pdf);
            weight *= Select((lightPDF > 1e18f) | MaskOf(ls.delta), 1.f, heuristic);
        }
        std::array<SampledSpectrum, kWide> gain;
        LaneBits some = 0;
        ForEachLane(lit, [&](int i) {
            gain[size_t(i)] = beta[size_t(i)] * ls.L[size_t(i)] * weight[i];
            if (gain[size_t(i)]) some |= LaneBits(1) << i;
        });
        batch.shadows.Add(slot, ray.time, OffsetOrigin(ls.wi), ls.pLight, gain.data(), some);
    }

    WidePoint3f OffsetOrigin(const WideVector3f &w) const {
        const WideFloat d = Dot(Abs(n), pError);
        return p + n * Select(Dot(w, n) < 0.f, -d, d);
    }

    void Continue() {
        const WidePoint2f u = draws.Direction();
        WideVector3f local;
        for (int i = 0; i < kWide; ++i)
            SetLane(&local, i, SampleCosineHemisphere({u.x[i], u.y[i]}));
        const WideFloat pdf = local.z * InvPi;
        local.z *= facing;
        // Frame::FromZ
        const WideFloat sign = CopySign(1.f, ns.z);
        const WideFloat a = -1.f / (sign + ns.z), b = ns.x * ns.y * a;
        const WideVector3f x{1.f + sign * ns.x * ns.x * a, sign * b, -sign * ns.x},
            y{b, sign + ns.y * ns.y * a, -ns.y};
        const WideVector3f d = local.x * x + local.y * y + local.z * ns;
        lanes &= BitsOf(pdf > 0.f);
        Survive();
        if (lanes == 0) return;
        batch.next->Add({slot, OffsetOrigin(d), d, ray.time, p, n, ns, pdf,
                         Gather(&batch.queue->etaScale[0], at), depth + 1u, WideUint{} + 1u,
                         beta.data()},
                        lanes);
    }

    /// Russian roulette, from the second bounce on.
    void Survive() {
        const WideFloat roulette = draws.Roulette();
        const WideFloat etaScale = Gather(&batch.queue->etaScale[0], at);
        const LaneBits early = BitsOf(std::bit_cast<WideInt>(depth) < 1);
        ForEachLane(lanes, [&](int i) {
            SampledSpectrum &b = beta[size_t(i)];
            const float importance = (b * etaScale[i]).MaxComponentValue();
            if (importance >= 1 || (early >> i & 1 && importance > 0)) return;
            if (!(importance > 0) || roulette[i] >= importance)
                lanes &= ~(LaneBits(1) << i);
            else
                b *= 1 / importance;
        });
    }

    const World &world;
    PathBatch &batch;
    VertexDraws<SamplerT> &draws;
    WideUint at, slot, depth;
    LaneBits lanes = 0;
    RayPacket ray;
    HitPacket hits;
    WidePoint3f p;
    WideVector3f pError;
    WideNormal3f n, ns;
    WideFloat facing;
    std::array<SampledSpectrum, kWide> beta;
};

}  // namespace pbrt
