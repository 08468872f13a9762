#pragma once

#include <bit>
#include <optional>
#include <vector>

#include "pbrt/base/light.h"
#include "pbrt/lights/emission.h"
#include "pbrt/lights/emitter.h"
#include "pbrt/lights/light_picture.h"
#include "pbrt/shapes/carried.h"
#include "pbrt/shapes/rectangle.h"
#include "pbrt/shapes/shapes.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// One primitive of a shape that emits from its outside (or from both sides) into every direction
/// the same radiance, less the shape's alpha: one spectrum, or a picture laid over the shape's uv,
/// its top at v = 1.
struct DiffuseAreaLight {
    static constexpr std::string_view kName = "diffuse";
    static constexpr LightTraits kTraits{.isArea = true, .isWide = true};
    static constexpr std::array<std::string_view, 6> kExamples{
        "",
        R"("bool twosided" true "rgb L" [ 3 2 1 ])",
        R"("float scale" 3)",
        R"("float power" 9)",
        R"("string filename" "example.exr")",
        R"("string filename" "example.exr" "float power" 9)"};
    static constexpr StringParam kFileName{"filename", "", "picture over the shape's uv, for L"};
    /// Data that the primitives of one shape share.
    struct Surface {
        Spectrum radiance;
        float luminance;
        const Shape *shape;
        bool twoSided;
        FloatTexture alpha;
        std::optional<Rectangle> rectangle;  ///< of a shape that is just that: sampled faster
        bool invisible;  ///< alpha is 0 everywhere: light samples reach it, rays do not
        std::shared_ptr<const LightPicture> picture;  ///< null: `radiance` everywhere
        const Instance *motion;  ///< carries the shape, which is in its own space; null: at rest

        SampledSpectrum Radiance(Point2f uv, const SampledWavelengths &lambda) const {
            if (!picture) return radiance.Sample(lambda);
            return picture->Sample(picture->TexelAt({uv.x, 1 - uv.y}), lambda);
        }
    };
    /// One light per primitive of the shape. As in pbrt-v4 `power` is what each primitive emits; of
    /// one that moves, at the shutter's opening.
    static std::vector<DiffuseAreaLight> Create(ParamDict &params, const EmitterArguments &emitter);

    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f u,
                                          const SampledWavelengths &lambda) const {
        const Surface &s = *surface;
        const std::optional<ShapeSample> at = SamplePoint(ctx, u);
        if (!at || !(at->pdf > 0)) return std::nullopt;
        const Vector3f d = at->p - ctx.p;
        const float d2 = LengthSquared(d), cosine = -Dot(at->n, d);
        const float off = Dot(Abs(at->n), at->pError);
        if (!(d2 > 0) || !(cosine > kInPlane * off || s.twoSided)) return std::nullopt;
        float strength = scale;
        if (!s.alpha.IsConstant() || s.alpha.Constant() != 1) strength *= Opacity(*at);
        if (strength == 0) return std::nullopt;
        return LightLiSample{s.Radiance(at->uv, lambda) * strength, d * (1 / std::sqrt(d2)),
                             at->pdf, at->p + at->n * (cosine > 0 ? off : -off), s.invisible};
    }
    float PDF_Hit(const LightSampleContext &ctx, Point3f p, Normal3f n) const {
        const Surface &s = *surface;
        if (s.rectangle) return s.rectangle->PDFFrom(ctx.p, p);
        if (s.motion) [[unlikely]]
            return PDFFromCarried(*s.shape, primitive, TransformAt(*s.motion, ctx.time), ctx.p, p,
                                  n);
        return PDFFrom(*s.shape, primitive, ctx.p, p, n);
    }
    SampledSpectrum L(Point3f, Normal3f n, Point2f uv, Vector3f w,
                      const SampledWavelengths &lambda) const {
        if (!surface->twoSided && !(Dot(n, w) > 0)) return SampledSpectrum(0.f);
        return surface->Radiance(uv, lambda) * scale;
    }
    /// Rectangles; two are as fast one by one.
    static LaneBits SampleLi(const LightsOf<DiffuseAreaLight> &lights,
                             const LightSampleContextX16 &ctx, const Point2fX16 &u,
                             const WavelengthPacket &lambda, LaneBits lanes,
                             LightLiSamples *samples) {
        LaneBits rectangles = 0;
        ForEachLane(lanes, [&](int i) {
            rectangles |= LaneBits(lights[size_t(i)]->IsPlainRectangle()) << i;
        });
        if (std::popcount(rectangles) <= 2) return 0;
        SampleRectangles(lights, ctx, u, lambda, rectangles, samples);
        return rectangles;
    }
    bool ReadsUV() const { return surface->picture != nullptr; }
    float Power() const;
    std::optional<LightBounds> Bounds() const;

    std::shared_ptr<const Surface> surface;
    uint32_t primitive = 0;
    float scale = 1;

  private:
    /// Receivers within so many errors of a one-sided light's plane are in it, and not lit: the
    /// light's own back, above all, which else rounding would light wherever alpha lets light
    /// through. Both points' errors and that of their difference, twice.
    static constexpr float kInPlane = 6;

    /// Rectangles of one radiance that let no light through, in the given lanes, one at least.
    static void SampleRectangles(const LightsOf<DiffuseAreaLight> &light,
                                 const LightSampleContextX16 &ctx, const Point2fX16 &u,
                                 const WavelengthPacket &lambda, LaneBits lanes,
                                 LightLiSamples *samples);
    bool IsPlainRectangle() const {
        const FloatTexture &alpha = surface->alpha;
        return surface->rectangle && !surface->picture && alpha.IsConstant() &&
               alpha.Constant() == 1;
    }
    std::optional<ShapeSample> SamplePoint(const LightSampleContext &ctx, Point2f u) const {
        const Surface &on = *surface;
        if (on.motion) [[unlikely]]
            return SampleFromCarried(*on.shape, primitive, TransformAt(*on.motion, ctx.time), ctx.p,
                                     u);
        if (!on.rectangle) return SampleFrom(*on.shape, primitive, ctx.p, u);
        const Rectangle &r = *on.rectangle;
        const Rectangle::Sample s = r.SampleFrom(ctx.p, u);
        return ShapeSample{s.p, r.Error(), r.Normal(), s.uv, s.pdf};
    }
    float Opacity(const ShapeSample &at) const;
    /// Area of the primitive at the shutter's opening.
    float EmittingArea() const;
};

inline void DiffuseAreaLight::SampleRectangles(const LightsOf<DiffuseAreaLight> &light,
                                               const LightSampleContextX16 &ctx,
                                               const Point2fX16 &u, const WavelengthPacket &lambda,
                                               LaneBits lanes, LightLiSamples *samples) {
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
    const FloatX16 off = Dot(Abs(r.Normal()), r.Error());
    const LaneBits lit =
        lanes & BitsOf((at.pdf > 0) & (d2 > 0)) & (BitsOf(cosine > kInPlane * off) | twoSided);
    const MaskX16 mask = MaskOf(lit);
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

}  // namespace pbrt
