#pragma once

#include "pbrt/base/light.h"
#include "pbrt/lights/emission.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// The same radiant intensity into all directions.
struct PointLight {
    static constexpr std::string_view kName = "point";
    static constexpr LightTraits kTraits{.isDelta = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        R"("point3 from" [ 1 2 3 ] "float scale" 6)", R"("rgb I" [ 3 2 1 ] "float power" 50)"};
    static PointLight Create(ParamDict &params, const Transform &renderFromLight);

    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f,
                                          const SampledWavelengths &lambda) const {
        const Vector3f d = p - ctx.p;
        const float d2 = LengthSquared(d);
        if (!(d2 > 0) || scale == 0) return std::nullopt;
        const Vector3f wi = d * (1 / std::sqrt(d2));
        return LightLiSample{intensity->Sample(lambda) * (scale / d2), wi, 1, p, true};
    }
    float Power() const { return 4 * Pi * scale * luminance; }
    std::optional<LightBounds> Bounds() const {
        return LightBounds{{p, p}, {{0, 0, 1}, -1}, 0, Power(), false};
    }

    std::shared_ptr<const Spectrum> intensity;
    Point3f p;
    float scale = 1;
    float luminance = 0;  ///< CIE-Y integral of `intensity`
};

}  // namespace pbrt
