#include "pbrt/cameras/thin_lens.h"

#include <fmt/format.h>

#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr FloatParam kLensRadius{
    "lensradius", "", 0, 0, kFarthest, "radius of the thin lens; 0: a pinhole"};
constexpr FloatParam kFocalDistance{
    "focaldistance", "", 1e6f, kShortestVector, kLongestVector, "distance of the plane in focus"};

}  // namespace

ThinLensRays ThinLensRays::Create(ParamDict &params, const CameraContext &context,
                                  const Affine &origin, const Affine &direction) {
    ThinLensRays rays;
    rays.placement = context.placement;
    rays.lensRadius = params.GetOneFloat(kLensRadius);
    rays.focalDistance = params.GetOneFloat(kFocalDistance);
    const Transform &placed = context.placement.renderFromCamera;
    rays.origin = {placed.Point(origin.start), placed.Vector(origin.perX),
                   placed.Vector(origin.perY)};
    rays.direction = {placed.Vector(direction.start), placed.Vector(direction.perX),
                      placed.Vector(direction.perY)};
    rays.right = context.placement.Right(), rays.up = context.placement.Up();
    const Vector3f forward = context.placement.Forward();
    rays.forward = forward / LengthSquared(forward);
    if (!rays.SetOrigins(context.resolution))
        params.Error(fmt::format(
            "{}: its transformation, screen window or lens makes rays that cannot be "
            "traced: origins may have coordinates up to {:g}; directions, and distances to what is "
            "in focus, be {:g} to {:g} long",
            params.What(), kFarthest, kShortestVector, kLongestVector));
    return rays;
}

bool ThinLensRays::SetOrigins(Point2i resolution) {
    const Vector3f lens = lensRadius * (Abs(right) + Abs(up));
    bool safe = HasSafeLength(forward);
    for (int i = 0; i < 4; ++i) {
        const Point2f corner{i & 1 ? float(resolution.x) : 0, i & 2 ? float(resolution.y) : 0};
        const Point3f o = At(origin, corner);
        const Vector3f d = At(direction, corner);
        origins.Grow({o - lens, o + lens});
        safe = safe && HasSafeLength(d);
        if (lensRadius > 0) safe = safe && HasSafeLength((focalDistance / DotAxis(d)) * d);
    }
    return safe && IsInRange(origins);
}

}  // namespace pbrt
