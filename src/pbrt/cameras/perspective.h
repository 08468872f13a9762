#pragma once

#include <array>

#include "pbrt/cameras/thin_lens.h"

namespace pbrt {

/// Pinhole or thin-lens camera; `fov` is that of the film's shorter axis.
class PerspectiveCamera {
  public:
    static constexpr std::string_view kName = "perspective";
    static constexpr CameraTraits kTraits{.hasPackets = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"float fov\" 20 \"float lensradius\" 0.1 \"float focaldistance\" 4",
        "\"float screenwindow\" [-1 0.5 -0.25 1]"};

    static PerspectiveCamera Create(ParamDict &params, const CameraContext &context);

    const CameraPlacement &Placement() const { return rays.Placement(); }
    bool HasLens() const { return rays.HasLens(); }
    Bounds3f Origins() const { return rays.Origins(); }
    Ray GenerateRay(Point2f film, Point2f lens, float time) const {
        return rays.GenerateRay(film, lens, time);
    }
    RayPacket GenerateRays(const Point2fX16 &film, const Point2fX16 &lens,
                           const FloatX16 &time) const {
        return rays.GenerateRays(film, lens, time);
    }
    /// As if the pixels' angle were everywhere that on the camera's axis.
    template <AnyFloat T>
    CameraView<T> ViewAt(Vec3<T> p) const {
        const Vec3<T> away = p - Repeated<T>(Placement().renderFromCamera.Point({0, 0, 0}));
        return {Normalize(away), Repeated<T>(rays.Right()), pixelAngle * Length(away)};
    }
    Transform NDCFromCamera() const { return ndcFromCamera; }

  private:
    ThinLensRays rays;
    float pixelAngle = 0;  ///< steps per unit distance
    Transform ndcFromCamera;
};
static_assert(CameraType<PerspectiveCamera>);

}  // namespace pbrt
