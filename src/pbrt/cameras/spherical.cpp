#include "pbrt/cameras/spherical.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pbrt/cameras/screen_window.h"
#include "pbrt/scene/params.h"
#include "pbrt/util/equal_area.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 2> kMappings{"equalarea", "equirectangular"};
constexpr ChoiceParam kMapping{"mapping", kMappings[0], kMappings,
                               "how the sphere of directions lies on the film"};
constexpr std::string_view kNoLens = "no effect: concerns cameras with a lens";
constexpr FloatParam kLensRadius{"lensradius", "", 0, 0, kOpen, kNoLens};
constexpr FloatParam kFocalDistance{"focaldistance", "", 1e30f, kAboveZero, kOpen, kNoLens};

/// The square continues over its edges: what leaves one comes back over the same edge, at the point
/// on the other side of the edge's middle.
Point2f Wrapped(Point2f p) {
    if (p.x < 0 || p.x > 1) p = {p.x < 0 ? -p.x : 2 - p.x, 1 - p.y};
    if (p.y < 0 || p.y > 1) p = {1 - p.x, p.y < 0 ? -p.y : 2 - p.y};
    return {std::clamp(p.x, 0.f, 1.f), std::clamp(p.y, 0.f, 1.f)};
}

/// The maps have z up, camera space has y up; the exchange is its own inverse.
Vector3f SwapYZ(Vector3f d) {
    return {d.x, d.z, d.y};
}

}  // namespace

SphericalCamera SphericalCamera::Create(ParamDict &params, const CameraContext &context) {
    SphericalCamera c;
    c.placement = context.placement;
    c.origin = c.placement.renderFromCamera.Point({0, 0, 0});
    if (!IsInRange(c.origin) || !HasSafeLength(c.placement.Right()) ||
        !HasSafeLength(c.placement.Up()) || !HasSafeLength(c.placement.Forward()))
        params.Error(
            fmt::format("{}: its transformation makes rays that cannot be traced", params.What()));
    c.resolution = {float(context.resolution.x), float(context.resolution.y)};
    c.equalArea = params.GetOneChoice(kMapping) == 0;
    // Accepted as pbrt-v4 does, which ignores them, too.
    ScreenWindow::Read(params, context.resolution);
    params.GetOneFloat(kLensRadius);
    params.GetOneFloat(kFocalDistance);
    return c;
}

Vector3f SphericalCamera::Direction(Point2f film) const {
    const Point2f uv{film.x / resolution.x, film.y / resolution.y};
    Vector3f d;
    if (equalArea) {
        d = EqualAreaSquareToSphere(Wrapped(uv));
    } else {
        const float theta = Pi * uv.y, phi = 2 * Pi * uv.x, sine = std::sin(theta);
        d = {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)};
    }
    return Normalize(placement.renderFromCamera.Vector(SwapYZ(d)));
}

Point2f SphericalCamera::OnFilm(Vector3f d) const {
    const Vector3f c = SwapYZ(Normalize(placement.renderFromCamera.Inverse().Vector(d)));
    Point2f uv;
    if (equalArea) {
        uv = EqualAreaSphereToSquare(c);
    } else {
        const float phi = std::atan2(c.y, c.x);
        uv = {(phi < 0 ? phi + 2 * Pi : phi) / (2 * Pi),
              std::atan2(std::hypot(c.x, c.y), c.z) / Pi};
    }
    return {uv.x * resolution.x, uv.y * resolution.y};
}

CameraView<float> SphericalCamera::ViewAt(Point3f p) const {
    const float distance = Length(p - origin);
    const Vector3f d = Normalize(distance > 0 ? p - origin : placement.Forward());
    const Point2f film = OnFilm(d);
    // The map's stretch differs from place to place: a difference over one pixel shows it.
    const Vector3f across = Direction({film.x + 0.5f, film.y}) - Direction({film.x - 0.5f, film.y});
    // Meridians meet at the poles: pixels there are as high as elsewhere, which is what counts.
    const float angle = equalArea ? Length(across) : 2 * Pi / resolution.x;
    return {d, across, angle * distance};
}

}  // namespace pbrt
