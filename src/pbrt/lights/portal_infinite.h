#pragma once

#include <array>

#include "pbrt/base/light.h"
#include "pbrt/lights/light_picture.h"
#include "pbrt/lights/windowed_distribution.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// A rectangle in the world, in rendering space. Light comes from the side to which z points.
struct Portal {
    Point3f corner;
    Vector3f x, y, z;  ///< unit; x and y along the sides
    float width, height;

    Vector3f ToLocal(Vector3f v) const { return {Dot(v, x), Dot(v, y), Dot(v, z)}; }
    Vector3f FromLocal(Vector3f v) const { return x * v.x + y * v.y + z * v.z; }
};

/// Light from infinity, of a picture or a spectrum, that comes through one rectangle alone: rays
/// that pass it from inside see what the light without portal shows, all others nothing. The four
/// points are places of the world, in order; who sees them run clockwise stands inside.
///
/// Directions are drawn by radiance within the portal as seen from the receiver: in coordinates of
/// the two angles at which planes through the portal's sides stand, it is a rectangle (Bitterli,
/// Novak, Jarosz 2015). The weights are of points of the picture, so that small bright spots can be
/// left to BSDF sampling.
struct PortalInfiniteLight {
    static constexpr std::string_view kName = "infinite";
    static constexpr LightTraits kTraits{
        .isInfinite = true, .readsSceneRadius = true, .dependsOnPlace = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        R"("string filename" "example.exr" "point3 portal" [ 7 7 6 7 -7 6 -7 -7 6 -7 7 6 ])",
        R"("rgb L" [ 1 2 3 ] "float illuminance" 3
           "point3 portal" [ 6 8 8 6 8 -8 6 -8 -8 6 -8 8 ])"};
    static constexpr ArrayParam kPortal{
        "portal", "point3", "light comes from everywhere",
        "rectangle through which all light comes, in the world; clockwise from inside"};
    /// `portal` must be given.
    static std::optional<PortalInfiniteLight> Create(ParamDict &params,
                                                     const Transform &renderFromLight,
                                                     const Transform &renderFromWorld);

    void Preprocess(float radius) { sceneRadius = radius; }
    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f u,
                                          const SampledWavelengths &lambda) const;
    SampledSpectrum Le(Point3f from, Vector3f d, const SampledWavelengths &lambda) const;
    float PDF_Li(Point3f from, Vector3f wi) const;
    float Power() const { return scenery->flux; }
    std::optional<LightBounds> Bounds() const { return std::nullopt; }

    struct Scenery {
        LightPicture picture;
        Transform lightFromRender;
        Portal portal;
        WindowedDistribution directions;
        float flux;  ///< luminous, through the portal
    };
    std::shared_ptr<const Scenery> scenery;
    float sceneRadius = 1;
};

}  // namespace pbrt
