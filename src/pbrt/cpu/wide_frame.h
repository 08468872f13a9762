#pragma once
#include "pbrt/util/wide.h"
namespace pbrt {
struct WideFrame {
    WideVector3f x, y, z;
    static WideFrame FromZ(const WideVector3f &z) {
        const WideFloat sign = CopySign(1.f, z.z);
        const WideFloat a = -1.f / (sign + z.z), b = z.x * z.y * a;
        return {{1.f + sign * z.x * z.x * a, sign * b, -sign * z.x},
                {b, sign + z.y * z.y * a, -z.y},
                z};
    }
    void Set(int i, const Frame &f) {
        SetLane(&x, i, f.x);
        SetLane(&y, i, f.y);
        SetLane(&z, i, f.z);
    }
    WideVector3f ToLocal(const WideVector3f &v) const { return {Dot(v, x), Dot(v, y), Dot(v, z)}; }
    WideVector3f FromLocal(const WideVector3f &v) const { return v.x * x + v.y * y + v.z * z; }
};
struct WideLightSampleContext {
    WidePoint3f p;
    WideNormal3f n, ns;
    LightSampleContext At(int i) const { return {Lane(p, i), Lane(n, i), Lane(ns, i)}; }
    void ForgetSide(int i) {
        SetLane(&n, i, {});
        SetLane(&ns, i, {});
    }
};
struct LightLiSamples {
    std::array<SampledSpectrum, kWide> L;
    WideVector3f wi{};
    WideFloat pdf{};
    WidePoint3f pLight{};
    LaneBits valid = 0, delta = 0;
};
inline void SampleLi(const std::array<const Light *, 16> &lights, const WideLightSampleContext &ctx,
                     const WidePoint2f &u, const std::array<const SampledWavelengths *, 16> &lambda,
                     LaneBits lanes, LightLiSamples *ls) {
    ForEachLane(lanes, [&](int i) {
        if (!lights[size_t(i)]) return;
        auto s = SampleLi(*lights[size_t(i)], ctx.At(i), {u.x[i], u.y[i]}, *lambda[size_t(i)]);
        if (!s || !(s->pdf > 0)) return;
        ls->valid |= LaneBits(1) << i;
        if (s->delta) ls->delta |= LaneBits(1) << i;
        ls->L[size_t(i)] = s->L;
        SetLane(&ls->wi, i, s->wi);
        SetLane(&ls->pLight, i, s->pLight);
        ls->pdf[i] = s->pdf;
    });
}
struct SurfacePoints {
    std::array<SurfacePoint, 16> s;
    WidePoint3f p;
    WideVector3f pError;
    WideNormal3f n, ns;
    WidePoint3f OffsetOrigin(const WideVector3f &w) const {
        const WideFloat d = Dot(Abs(n), pError);
        return p + n * Select(Dot(w, n) < 0.f, -d, d);
    }
};
inline const SurfacePoint &Lane(const SurfacePoints &s, int i) {
    return s.s[size_t(i)];
}
inline void SetLane(SurfacePoints *q, int i, const SurfacePoint &sp) {
    q->s[size_t(i)] = sp;
    SetLane(&q->p, i, sp.p);
    SetLane(&q->pError, i, sp.pError);
    SetLane(&q->n, i, sp.n);
    SetLane(&q->ns, i, sp.ns);
}
}  // namespace pbrt
