#include "pbrt/shapes/quadric_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/util/range.h"

namespace pbrt {

QuadricReader::QuadricReader(const ShapeArguments &a) : a(a), before(a.params.Log().ErrorCount()) {
    const auto &m = a.renderFromObject.Matrix();
    if (m[3] != std::array<float, 4>{0, 0, 0, 1})
        Fail("", "cannot be placed by a perspective transform");
}
float QuadricReader::PhiMax() {
    const float degrees = a.params.GetOneFloat(kPhiMax);
    return degrees >= 360 ? 2 * Pi : Radians(degrees);
}

void QuadricReader::ZRange(float *zMin, float *zMax) {
    FloatParam low = kZMin, high = kZMax;
    low.def = *zMin, high.def = *zMax;
    *zMin = a.params.GetOneFloat(low);
    *zMax = a.params.GetOneFloat(high);
    if (!(*zMin < *zMax))
        Fail(a.params.Has(kZMin) ? kZMin.name : kZMax.name,
             fmt::format("zmin, {}, is not less than zmax, {}", *zMin, *zMax));
}

float QuadricReader::FloatBelow(const FloatParam &row, float limit) {
    const float value = a.params.GetOneFloat(row);
    if (!(value < limit))
        Fail(row.name, fmt::format("\"float {}\": {} is outside [0, {})", row.name, value, limit));
    return value;
}

void QuadricReader::Fail(std::string_view name, std::string_view message) {
    if (name.empty())
        a.params.Error(fmt::format("{} {}", a.params.What(), message));
    else
        a.params.Error(name, message);
}
float QuadricReader::Unit(float radius) {
    return radius > 1e-6f && radius < 1e6f ? 1 : std::ldexp(1.f, std::ilogb(radius));
}
void QuadricReader::CheckSize(const Transform &renderFromObject) {
    const Transform inverse = renderFromObject.Inverse();
    for (const Vector3f &axis : {Vector3f{1, 0, 0}, Vector3f{0, 1, 0}, Vector3f{0, 0, 1}})
        if (Ok() &&
            !(HasSafeLength(renderFromObject.Vector(axis)) && HasSafeLength(inverse.Vector(axis))))
            Fail("",
                 fmt::format("is {:g} in size where it stands; {:g} to {:g} can be traced",
                             Length(renderFromObject.Vector(axis)), kShortestVector, kFarthest));
}
}  // namespace pbrt
