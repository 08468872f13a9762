#pragma once

#include <bit>
#include <vector>

#include "pbrt/base/light.h"
#include "pbrt/image/image.h"
#include "pbrt/lights/emission.h"
#include "pbrt/lights/light_picture.h"
#include "pbrt/util/equal_area.h"
#include "pbrt/util/piecewise_constant.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// A square equal-area octahedral picture, what its RGB means, and the factor of its radiance.
struct SkyPicture {
    Image image;
    const RGBColorSpace *space;
    float scale;
};
/// Reads `filename`, `scale` and `illuminance`; nullopt after an error.
std::optional<SkyPicture> ReadSkyPicture(ParamDict &params);

/// Radiance from infinity by a square equal-area octahedral image, constant within each texel as
/// in pbrt-v4.
///
/// Directions are drawn from the texels' luminance less its mean, cut at 0 (Karlik et al. 2019,
/// "MIS Compensation"): dim parts are never drawn, so the estimate is right only together with
/// BSDF sampling.
struct ImageInfiniteLight {
    static constexpr std::string_view kName = "infinite";
    static constexpr LightTraits kTraits{
        .isInfinite = true, .readsSceneRadius = true, .isWide = true, .isWideSeen = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        R"("string filename" "example.exr")",
        R"("string filename" "example.exr" "float illuminance" 40)"};
    static constexpr StringParam kFileName{
        "filename", "", "square picture of all directions, equal-area octahedral"};
    /// `filename` must be given.
    static std::optional<ImageInfiniteLight> Create(ParamDict &params,
                                                    const Transform &renderFromLight);
    /// `scale` multiplies radiance. The image has channels R, G, B, as many rows as columns,
    /// finite values (below 0 counts as 0).
    static ImageInfiniteLight FromImage(const Image &image, const RGBColorSpace &colorSpace,
                                        float scale, const Transform &renderFromLight);
    /// The most memory that FromImage takes, beside the image.
    static uint64_t BytesToCreate(const Image &image);
    /// CIE Y that reaches an upward-facing (+z in light space) patch at scale 1.
    static float Illuminance(const Image &image, const RGBColorSpace &colorSpace);

    void Preprocess(float radius) { sceneRadius = radius; }
    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f u,
                                          const SampledWavelengths &lambda) const {
        const PiecewiseConstant2D::PointSample s = sky->directions.Sample(u);
        const auto [wi, pdf] = Leave(s.p, s.pdf);
        const SampledSpectrum L = Radiance(s.step, lambda);
        if (!(pdf > 0) || !L) return std::nullopt;
        return LightLiSample{L, wi, pdf, ctx.p + (2 * sceneRadius) * wi, false};
    }
    /// Lanes that share a light are sampled together; two are as fast one by one.
    static LaneBits SampleLi(const LightsOf<ImageInfiniteLight> &lights,
                             const LightSampleContextX16 &ctx, const Point2fX16 &u,
                             const WavelengthPacket &lambda, LaneBits lanes,
                             LightLiSamples *samples) {
        LaneBits done = 0, left = lanes;
        while (std::popcount(left) > 2) {
            const ImageInfiniteLight *const light = lights[size_t(std::countr_zero(left))];
            LaneBits same = 0;
            ForEachLane(left, [&](int i) { same |= LaneBits(lights[size_t(i)] == light) << i; });
            light->SampleLiOfOne(ctx, u, lambda, same, samples);
            done |= same;
            left &= ~same;
        }
        return done;
    }
    /// Place in the image and density of a direction. T: float or FloatX16.
    template <typename T>
    struct Place {
        Vec2<T> p;  ///< in the square
        T pdf;      ///< of SampleLi
    };
    template <AnyFloat T>
    Place<T> Along(Vec3<T> d) const {
        const Vec3<T> w = sky->lightFromRender.Vector(d);
        const T invLength = 1 / Length(w);
        const Vec2<T> p = EqualAreaSphereToSquare(Vec3<T>(w * invLength));
        return {p,
                sky->directions.PDF(p) * (1 / (4 * Pi)) * Sqr(invLength) * invLength * sky->invDet};
    }
    template <AnyFloat T>
    T PDF_Li(Vec3<T> wi) const {
        return Along(wi).pdf;
    }
    SampledSpectrum Le(Vector3f d, const SampledWavelengths &lambda) const {
        return RadianceAt(Along(d).p, lambda);
    }
    SampledSpectrum RadianceAt(Point2f p, const SampledWavelengths &lambda) const {
        const int n = sky->picture.Resolution().x;
        return Radiance({detail::StepAt(p.x, n), detail::StepAt(p.y, n)}, lambda);
    }
    void Le(const Vector3fX16 &d, const WavelengthPacket &lambda, LaneBits lanes,
            LightLePacket *le) const {
        const Place<FloatX16> place = Along(d);
        le->pdf = place.pdf;
        ForEachLane(lanes, [&](int i) {
            le->L[size_t(i)] = RadianceAt(Lane(place.p, i), *lambda[size_t(i)]);
        });
    }
    float Power() const { return 4 * Sqr(Pi * sceneRadius) * sky->picture.MeanLuminance(); }
    std::optional<LightBounds> Bounds() const { return std::nullopt; }

    struct Sky {
        Transform renderFromLight, lightFromRender;
        float invDet;  ///< of renderFromLight, absolute
        LightPicture picture;
        PiecewiseConstant2D directions;
    };
    SampledSpectrum Radiance(Point2i texel, const SampledWavelengths &lambda) const {
        return sky->picture.Sample(texel, lambda);
    }

    /// A direction drawn in the square, in rendering space.
    template <typename T>
    struct Direction {
        Vec3<T> wi;
        T pdf;  ///< per unit solid angle
    };
    template <AnyFloat T>
    Direction<T> Leave(Vec2<T> square, T pdf) const {
        const Vec3<T> w = sky->renderFromLight.Vector(EqualAreaSquareToSphere(square));
        // Solid angle shrinks by |w|^3 / det under the transform.
        const T length = Length(w);
        return {w * (1 / length), pdf * (1 / (4 * Pi)) * (length * length * length) * sky->invDet};
    }

    std::shared_ptr<const Sky> sky;
    float sceneRadius = 1;

  private:
    /// SampleLi in the given lanes.
    void SampleLiOfOne(const LightSampleContextX16 &ctx, const Point2fX16 &u,
                       const WavelengthPacket &lambda, LaneBits lanes,
                       LightLiSamples *samples) const {
        const PiecewiseConstant2D::PointSampleX16 s = sky->directions.Sample(u);
        const auto [wi, pdf] = Leave(s.p, s.pdf);
        const MaskX16 mask = MaskOf(lanes);
        samples->wi = Select(mask, wi, samples->wi);
        samples->pdf = Select(mask, pdf, samples->pdf);
        samples->pLight = Select(mask, ctx.p + (2 * sceneRadius) * wi, samples->pLight);
        ForEachLane(lanes & BitsOf(pdf > 0), [&](int i) {
            const SampledSpectrum L =
                Radiance({int(s.column[i]), int(s.row[i])}, *lambda[size_t(i)]);
            samples->L[size_t(i)] = L;
            samples->valid |= LaneBits(bool(L)) << i;
        });
    }
};

}  // namespace pbrt
