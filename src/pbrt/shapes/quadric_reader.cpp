#include "pbrt/shapes/quadric_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/util/range.h"

namespace pbrt {

QuadricReader::QuadricReader(const ShapeArguments &a) : a(a) {
    const auto &m = a.renderFromObject.Matrix();
    if (m[3] != std::array<float, 4>{0, 0, 0, 1})
        Fail("", "cannot be placed by a perspective transform");
}
float QuadricReader::Radius() {
    const float radius = a.params.GetOneFloat("radius", 1);
    if (radius > 0 && radius < Infinity) return radius;
    Fail("radius", fmt::format("\"float radius\": {} is not more than 0", radius));
    return 1;
}
float QuadricReader::PhiMax() {
    const float degrees = a.params.GetOneFloat("phimax", 360);
    if (!(degrees > 0 && degrees <= 360))
        Fail("phimax", fmt::format("\"float phimax\": {} is outside (0, 360] deg", degrees));
    return degrees >= 360 ? 2 * Pi : Radians(degrees);
}
void QuadricReader::ZRange(float *zMin, float *zMax) {
    *zMin = a.params.GetOneFloat("zmin", *zMin);
    *zMax = a.params.GetOneFloat("zmax", *zMax);
    if (!(*zMin < *zMax))
        Fail(a.params.Has("zmin", "float") ? "zmin" : "zmax",
             fmt::format("zmin, {}, is not less than zmax, {}", *zMin, *zMax));
}
float QuadricReader::FloatBelow(std::string_view name, float def, float limit) {
    const float value = a.params.GetOneFloat(name, def);
    if (!(value >= 0 && value < limit))
        Fail(name, fmt::format("\"float {}\": {} is outside [0, {})", name, value, limit));
    return value;
}

void QuadricReader::Fail(std::string_view name, std::string_view message) {
    if (name.empty())
        a.params.Error(fmt::format("{} {}", a.params.What(), message));
    else
        a.params.Error(name, message);
    ok = false;
}
float QuadricReader::Unit(float radius) {
    return radius > 1e-6f && radius < 1e6f ? 1 : std::ldexp(1.f, std::ilogb(radius));
}
void QuadricReader::CheckSize(const Transform &renderFromObject) {
    const Transform inverse = renderFromObject.Inverse();
    for (const Vector3f &axis : {Vector3f{1, 0, 0}, Vector3f{0, 1, 0}, Vector3f{0, 0, 1}})
        if (ok &&
            !(HasSafeLength(renderFromObject.Vector(axis)) && HasSafeLength(inverse.Vector(axis))))
            Fail("",
                 fmt::format("is {:g} in size where it stands; {:g} to {:g} can be traced",
                             Length(renderFromObject.Vector(axis)), kShortestVector, kFarthest));
}
}  // namespace pbrt
