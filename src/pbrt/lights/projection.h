#pragma once

#include "pbrt/base/light.h"
#include "pbrt/lights/light_picture.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// A point light that throws a picture along the +z axis of its space, from the origin: its shorter
/// side subtends `fov`, its top lies towards +y. The intensity is the picture's, constant within
/// each texel.
struct ProjectionLight {
    static constexpr std::string_view kName = "projection";
    static constexpr LightTraits kTraits{.isDelta = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        R"("string filename" "example.exr")",
        R"("string filename" "example.exr" "float fov" 40 "float power" 50)"};
    static std::optional<ProjectionLight> Create(ParamDict &params,
                                                 const Transform &renderFromLight);

    /// Texel that is thrown into the direction w of the light's space; nullopt beside the picture.
    std::optional<Point2i> TexelAlong(Vector3f w) const {
        if (!(w.z > 0)) return std::nullopt;
        const Point2f at{w.x / w.z, w.y / w.z}, half = projector->half;
        if (!(std::abs(at.x) <= half.x && std::abs(at.y) <= half.y)) return std::nullopt;
        return projector->picture.TexelAt({(1 + at.x / half.x) / 2, (1 - at.y / half.y) / 2});
    }
    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f,
                                          const SampledWavelengths &lambda) const {
        const Vector3f d = p - ctx.p;
        const float d2 = LengthSquared(d);
        if (!(d2 > 0)) return std::nullopt;
        const auto texel = TexelAlong(projector->lightFromRender.Vector(-d));
        if (!texel) return std::nullopt;
        const SampledSpectrum intensity = projector->picture.Sample(*texel, lambda);
        if (!intensity) return std::nullopt;
        return LightLiSample{intensity * (scale / d2), d * (1 / std::sqrt(d2)), 1, p, true};
    }
    float Power() const { return scale * projector->flux; }
    std::optional<LightBounds> Bounds() const;

    struct Projector {
        LightPicture picture;
        Transform lightFromRender;
        Point2f half;  ///< half the picture's sides in the plane z = 1
        float flux;    ///< luminous, at scale 1, in rendering space
    };
    std::shared_ptr<const Projector> projector;
    Point3f p;
    float scale = 1;
};

}  // namespace pbrt
