#pragma once

#include "pbrt/lights/emission.h"
#include "pbrt/lights/light.h"
#include "pbrt/lights/light_bounds.h"
#include "pbrt/shapes/rectangle.h"
#include "pbrt/shapes/shape.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// One primitive of a shape that emits the same radiance from every point of its outside (or of
/// both sides) into every direction, less the shape's alpha.
struct DiffuseAreaLight {
    static constexpr std::string_view kName = "diffuse";
    /// What the primitives of one shape share.
    struct Surface {
        Spectrum radiance;
        float luminance;
        const Shape *shape;
        bool twoSided;
        FloatTexture alpha;
        std::optional<Rectangle> rectangle;  ///< of a shape that is just that: sampled faster
        bool invisible;  ///< alpha is 0 everywhere: light samples reach it, rays do not
    };
    /// One light per primitive of `shape`, which must outlive them. As in pbrt-v4 `power` is what
    /// each primitive emits.
    static std::vector<DiffuseAreaLight> Create(ParamDict &params, const Shape &shape,
                                                const FloatTexture &alpha);

    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f u,
                                          const SampledWavelengths &lambda) const {
        const Surface &s = *surface;
        const std::optional<ShapeSample> at = SamplePoint(ctx.p, u);
        if (!at || !(at->pdf > 0)) return std::nullopt;
        const Vector3f d = at->p - ctx.p;
        const float d2 = LengthSquared(d), cosine = -Dot(at->n, d);
        if (!(d2 > 0) || !(cosine > 0 || s.twoSided)) return std::nullopt;
        float strength = scale;
        if (!s.alpha.IsConstant() || s.alpha.Constant() != 1) strength *= Opacity(*at);
        if (strength == 0) return std::nullopt;
        const float off = Dot(Abs(at->n), at->pError);
        return LightLiSample{s.radiance.Sample(lambda) * strength, d * (1 / std::sqrt(d2)), at->pdf,
                             at->p + at->n * (cosine > 0 ? off : -off), s.invisible};
    }
    /// Density of SampleLi for the direction wi from ref, which meets the surface at p.
    float PDF(Point3f ref, Vector3f wi, Point3f p, Normal3f n) const {
        if (surface->rectangle) return surface->rectangle->PDFFrom(ref, p);
        return PDFFrom(*surface->shape, primitive, ref, wi, p, n);
    }
    /// Radiance that leaves a point seen with normal n into direction w.
    SampledSpectrum L(Normal3f n, Vector3f w, const SampledWavelengths &lambda) const {
        if (!surface->twoSided && !(Dot(n, w) > 0)) return SampledSpectrum(0.f);
        return surface->radiance.Sample(lambda) * scale;
    }
    float Power() const;
    std::optional<LightBounds> Bounds() const;

    std::shared_ptr<const Surface> surface;
    uint32_t primitive = 0;
    float scale = 1;

  private:
    std::optional<ShapeSample> SamplePoint(Point3f ref, Point2f u) const {
        if (!surface->rectangle) return SampleFrom(*surface->shape, primitive, ref, u);
        const Rectangle &r = *surface->rectangle;
        const Rectangle::Sample s = r.SampleFrom(ref, u);
        return ShapeSample{s.p, r.Error(), r.Normal(), s.uv, s.pdf};
    }
    float Opacity(const ShapeSample &at) const;
};

}  // namespace pbrt
