#pragma once

#include <array>

#include "pbrt/cameras/thin_lens.h"

namespace pbrt {

/// Parallel rays along the camera's z axis, through a thin lens if there is one. The film shows the
/// screen window in units of camera space.
class OrthographicCamera {
  public:
    static constexpr std::string_view kName = "orthographic";
    static constexpr CameraTraits kTraits{.hasPackets = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"float lensradius\" 0.1 \"float focaldistance\" 4",
        "\"float screenwindow\" [-1 0.5 -0.25 1]"};

    static OrthographicCamera Create(ParamDict &params, const CameraContext &context);

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
    template <AnyFloat T>
    CameraView<T> ViewAt(Vec3<T>) const {
        return {Repeated<T>(Normalize(rays.Forward())), Repeated<T>(rays.Right()), T{} + pixelSize};
    }
    Transform NDCFromCamera() const { return ndcFromCamera; }

  private:
    ThinLensRays rays;
    float pixelSize = 0;
    Transform ndcFromCamera;
};
static_assert(CameraType<OrthographicCamera>);

}  // namespace pbrt
