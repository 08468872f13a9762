#pragma once

#include <vector>

#include "pbrt/base/light.h"
#include "pbrt/lights/emission.h"
#include "pbrt/util/equal_area.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// A point light whose intensity a picture of all directions scales: square, equal-area octahedral,
/// with y and z exchanged, so that its middle is the light's +y, as in pbrt-v4. R, G and B count by
/// their mean. Stands at the origin of its space.
struct GoniometricLight {
    static constexpr std::string_view kName = "goniometric";
    static constexpr LightTraits kTraits{.isDelta = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        R"("string filename" "example.exr")",
        R"("string filename" "example.exr" "rgb I" [ 3 2 1 ] "float power" 50)"};
    static std::optional<GoniometricLight> Create(ParamDict &params,
                                                  const Transform &renderFromLight);

    /// The picture's value in the direction w, rendering space, of any length.
    float Factor(Vector3f w) const {
        const Vector3f local = Normalize(diagram->lightFromRender.Vector(w));
        const Point2f uv = EqualAreaSphereToSquare(Vector3f{local.x, local.z, local.y});
        const int n = diagram->resolution;
        const auto at = [n](float x) { return size_t(std::min(int(x * float(n)), n - 1)); };
        return diagram->factors[at(uv.y) * size_t(n) + at(uv.x)];
    }
    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f,
                                          const SampledWavelengths &lambda) const {
        const Vector3f d = p - ctx.p;
        const float d2 = LengthSquared(d);
        if (!(d2 > 0)) return std::nullopt;
        const float strength = scale * Factor(-d);
        if (strength == 0) return std::nullopt;
        return LightLiSample{diagram->intensity->Sample(lambda) * (strength / d2),
                             d * (1 / std::sqrt(d2)), 1, p, true};
    }
    float Power() const { return 4 * Pi * diagram->mean * scale * diagram->luminance; }
    std::optional<LightBounds> Bounds() const {
        return LightBounds{{p, p}, {{0, 0, 1}, -1}, 0, Power(), false};
    }

    struct Diagram {
        std::shared_ptr<const Spectrum> intensity;
        float luminance;  ///< CIE-Y integral of `intensity`
        Transform lightFromRender;
        int resolution;
        std::vector<float> factors;  ///< row by row
        float mean;                  ///< of them
    };
    std::shared_ptr<const Diagram> diagram;
    Point3f p;
    float scale = 1;
};

}  // namespace pbrt
