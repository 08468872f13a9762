#include "pbrt/lights/from_to.h"

#include <fmt/format.h>

#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr PointParam kTo{"to", "point3", {0, 0, 1}, "a point that the light shines to"};

}  // namespace

FromTo GetFromTo(ParamDict &params, const Transform &renderFromLight) {
    const Point3f from = params.GetOnePoint3f(kLightFrom);
    const Point3f to = params.GetOnePoint3f(kTo);
    const Vector3f along = to - from;
    if (from == to)
        params.Error(kTo.name, "\"from\" and \"to\" are the same point: no direction");
    else if (HasSafeLength(along) && HasSafeLength(renderFromLight.Vector(along)))
        return {from, along};
    else
        params.Error(kTo.name,
                     fmt::format("the distance of \"from\" and \"to\" is not {:g} to {:g}",
                                 kShortestVector, kLongestVector));
    return {from, {0, 0, 1}};
}

}  // namespace pbrt
