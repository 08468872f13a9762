#pragma once

#include <array>

#include "pbrt/base/camera.h"

namespace pbrt {

/// All directions from one point. `mapping` "equalarea": the film is the square of
/// util/equal_area.h; "equirectangular": longitude across, colatitude down. In both the camera's up
/// is the map's pole (the middle of the square, the top of the film).
class SphericalCamera {
  public:
    static constexpr std::string_view kName = "spherical";
    static constexpr CameraTraits kTraits{};
    static constexpr std::array<std::string_view, 2> kExamples{
        "", "\"string mapping\" \"equirectangular\""};

    static SphericalCamera Create(ParamDict &params, const CameraContext &context);

    const CameraPlacement &Placement() const { return placement; }
    bool HasLens() const { return false; }
    Bounds3f Origins() const { return {origin, origin}; }
    Ray GenerateRay(Point2f film, Point2f, float time) const {
        return {origin, Direction(film), Infinity, placement.TimeAt(time)};
    }
    CameraView<float> ViewAt(Point3f p) const;
    /// A map of the sphere is no matrix.
    Transform NDCFromCamera() const { return {}; }

  private:
    /// Seen at a position on the film, in pixels; unit, in rendering space.
    Vector3f Direction(Point2f film) const;
    /// Inverse of Direction, for any length.
    Point2f OnFilm(Vector3f d) const;

    CameraPlacement placement;
    Point3f origin;
    Vector2f resolution{1, 1};
    bool equalArea = true;
};
static_assert(CameraType<SphericalCamera>);

}  // namespace pbrt
