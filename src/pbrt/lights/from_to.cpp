#include "pbrt/lights/from_to.h"

#include <fmt/format.h>

#include "pbrt/util/range.h"

namespace pbrt {

FromTo GetFromTo(ParamDict &params, const Transform &renderFromLight) {
    const Point3f from = params.GetOnePoint3f("from", {});
    const Point3f to = params.GetOnePoint3f("to", {0, 0, 1});
    const Vector3f along = to - from;
    if (from == to)
        params.Error("to", "\"from\" and \"to\" are the same point: no direction");
    else if (HasSafeLength(along) && HasSafeLength(renderFromLight.Vector(along)))
        return {from, along};
    else
        params.Error("to", fmt::format("the distance of \"from\" and \"to\" is not {:g} to {:g}",
                                       kShortestVector, kLongestVector));
    return {from, {0, 0, 1}};
}

}  // namespace pbrt
