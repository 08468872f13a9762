#pragma once

#include <array>

#include "pbrt/lights/lights.h"

namespace pbrt {

using LightPacket = std::array<const Light *, kPacketSize>;
using WavelengthPacket = std::array<const SampledWavelengths *, kPacketSize>;

namespace detail {

/// A light that SampleRectangles can handle; else nullptr.
inline const DiffuseAreaLight *AsRectangle(const Light &light) {
    const auto *area = std::get_if<DiffuseAreaLight>(&light);
    if (!area || !area->surface->rectangle) return nullptr;
    const FloatTexture &alpha = area->surface->alpha;
    return alpha.IsConstant() && alpha.Constant() == 1 ? area : nullptr;
}

/// DiffuseAreaLight::SampleLi in the given lanes, one at least.
inline void SampleRectangles(const std::array<const DiffuseAreaLight *, kPacketSize> &light,
                             const LightSampleContextX16 &ctx, const Point2fX16 &u,
                             const WavelengthPacket &lambda, LaneBits lanes,
                             LightLiSamples *samples) {
    std::array<const Rectangle *, kPacketSize> rectangle;
    LaneBits twoSided = 0, invisible = 0;
    for (size_t i = 0; i < kPacketSize; ++i) {
        const size_t from = lanes >> i & 1 ? i : size_t(std::countr_zero(lanes));
        const DiffuseAreaLight::Surface &s = *light[from]->surface;
        rectangle[i] = &*s.rectangle;
        twoSided |= LaneBits(s.twoSided) << i;
        invisible |= LaneBits(s.invisible) << i;
    }
    const auto r = RectangleT<FloatX16>::Of(rectangle);
    const auto at = r.SampleFrom(ctx.p, u);
    const Vector3fX16 d = at.p - ctx.p;
    const FloatX16 d2 = LengthSquared(d), cosine = -Dot(r.Normal(), d);
    const LaneBits lit = lanes & BitsOf((at.pdf > 0) & (d2 > 0)) & (BitsOf(cosine > 0) | twoSided);
    const MaskX16 mask = MaskOf(lit);
    const FloatX16 off = Dot(Abs(r.Normal()), r.Error());
    samples->wi = Select(mask, d * (1 / Sqrt(d2)), samples->wi);
    samples->pdf = Select(mask, at.pdf, samples->pdf);
    samples->pLight =
        Select(mask, at.p + r.Normal() * Select(cosine > 0, off, -off), samples->pLight);
    samples->delta |= lit & invisible;
    ForEachLane(lit, [&](int i) {
        const DiffuseAreaLight &l = *light[size_t(i)];
        samples->L[size_t(i)] = l.surface->radiance.Sample(*lambda[size_t(i)]) * l.scale;
        samples->valid |= LaneBits(l.scale != 0) << i;
    });
}

}  // namespace detail

/// SampleLi of light[lane] in the given lanes, those without a light (nullptr) apart. What is
/// sampled becomes valid; other lanes' wi, pdf and pLight become undefined.
inline void SampleLi(const LightPacket &light, const LightSampleContextX16 &ctx,
                     const Point2fX16 &u, const WavelengthPacket &lambda, LaneBits lanes,
                     LightLiSamples *samples) {
    std::array<const DiffuseAreaLight *, kPacketSize> area{};
    LaneBits rectangles = 0, images = 0, others = 0;
    ForEachLane(lanes, [&](int i) {
        const Light *const l = light[size_t(i)];
        if (!l) return;
        area[size_t(i)] = detail::AsRectangle(*l);
        LaneBits &kind = area[size_t(i)]                                  ? rectangles
                         : std::holds_alternative<ImageInfiniteLight>(*l) ? images
                                                                          : others;
        kind |= LaneBits(1) << i;
    });
    // Two are as fast one by one.
    if (std::popcount(rectangles) > 2)
        detail::SampleRectangles(area, ctx, u, lambda, rectangles, samples);
    else
        others |= rectangles;
    while (std::popcount(images) > 2) {
        const Light *const l = light[size_t(std::countr_zero(images))];
        LaneBits same = 0;
        ForEachLane(images, [&](int i) { same |= LaneBits(light[size_t(i)] == l) << i; });
        std::get_if<ImageInfiniteLight>(l)->SampleLi(ctx, u, lambda, same, samples);
        images &= ~same;
    }
    ForEachLane(others | images, [&](int i) {
        const auto s = SampleLi(*light[size_t(i)], ctx.At(i), Lane(u, i), *lambda[size_t(i)]);
        if (s) samples->Set(i, *s);
    });
}

}  // namespace pbrt
