#pragma once

#include "pbrt/base/light.h"
#include "pbrt/lights/emission.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// A point light that shines into a cone: full intensity up to coneangle - conedeltaangle from the
/// axis, none beyond coneangle, a cubic smooth step in the cosine between.
struct SpotLight {
    static constexpr std::string_view kName = "spot";
    static constexpr LightTraits kTraits{.isDelta = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        R"("point3 to" [ 0 1 0 ])",
        R"("point3 to" [ 0 1 3 ] "float coneangle" 120 "float conedeltaangle" 30)",
        R"("float coneangle" 10 "float conedeltaangle" 0)"};
    static SpotLight Create(ParamDict &params, const Transform &renderFromLight);

    /// Share of the full intensity at an angle from the axis.
    float Falloff(float cosTheta) const {
        if (cosTheta >= beam->cosStart) return 1;
        const float x = (cosTheta - beam->cosEnd) / (beam->cosStart - beam->cosEnd);
        return x <= 0 ? 0 : x * x * (3 - 2 * x);
    }
    /// Cosine between the axis and a direction that leaves the light, in the light's own space.
    float CosTheta(Vector3f w) const {
        const Vector3f local = beam->lightFromRender.Vector(w);
        return Dot(local, beam->axis) / Length(local);
    }
    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f,
                                          const SampledWavelengths &lambda) const {
        const Vector3f d = p - ctx.p;
        const float d2 = LengthSquared(d);
        if (!(d2 > 0)) return std::nullopt;
        const Vector3f wi = d * (1 / std::sqrt(d2));
        const float strength = scale * Falloff(CosTheta(-wi));
        if (strength == 0) return std::nullopt;
        return LightLiSample{beam->intensity->Sample(lambda) * (strength / d2), wi, 1, p, true};
    }
    float Power() const;
    std::optional<LightBounds> Bounds() const;

    struct Beam {
        std::shared_ptr<const Spectrum> intensity;
        float luminance;
        Transform lightFromRender;
        Vector3f axis;  ///< unit, light space
        float cosStart, cosEnd;
        float solidAngle;  ///< of the cone in rendering space, weighted by the falloff
        bool keepsAngles;  ///< the cone is round in rendering space, too
    };
    std::shared_ptr<const Beam> beam;
    Point3f p;
    float scale = 1;
};

}  // namespace pbrt
