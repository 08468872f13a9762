#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "pbrt/shapes/create.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr FloatParam kRadius{"radius", "", 1, kAboveZero, kOpen, "distance of the surface"};
constexpr FloatParam kZMin{"zmin", "", -1, -kOpen, kOpen, "lower cut; a sphere's default: -radius"};
constexpr FloatParam kZMax{"zmax", "", 1, -kOpen, kOpen, "upper cut; a sphere's default: radius"};
constexpr FloatParam kPhiMax{"phimax",   "deg", 360,
                             kAboveZero, 360,   "how far the surface goes round the z axis"};
constexpr FloatParam kHeight{"height", "", 0, -kOpen, kOpen, "z of the disk"};
constexpr FloatParam kInnerRadius{
    "innerradius", "", 0, 0, kOpen, "radius of the hole, less than radius"};

/// Parameters that quadrics share, each with its check.
class QuadricReader {
  public:
    explicit QuadricReader(const ShapeArguments &a) : a(a), before(a.params.Log().ErrorCount()) {
        const auto &m = a.renderFromObject.Matrix();
        if (m[3] != std::array<float, 4>{0, 0, 0, 1})
            Fail("", "cannot be placed by a perspective transform");
    }

    float Radius() { return a.params.GetOneFloat(kRadius); }

    /// In radians, (0, 2 pi].
    float PhiMax() {
        const float degrees = a.params.GetOneFloat(kPhiMax);
        return degrees >= 360 ? 2 * Pi : Radians(degrees);
    }

    /// zmin < zmax; *zMin and *zMax are the defaults.
    void ZRange(float *zMin, float *zMax) {
        FloatParam low = kZMin, high = kZMax;
        low.def = *zMin, high.def = *zMax;
        *zMin = a.params.GetOneFloat(low);
        *zMax = a.params.GetOneFloat(high);
        if (!(*zMin < *zMax))
            Fail(a.params.Has(kZMin) ? kZMin.name : kZMax.name,
                 fmt::format("zmin, {}, is not less than zmax, {}", *zMin, *zMax));
    }

    void Fail(std::string_view name, std::string_view message) {
        if (name.empty())
            a.params.Error(fmt::format("{} {}", a.params.What(), message));
        else
            a.params.Error(name, message);
    }

    /// `lengths`: all the quadric has.
    template <typename Q>
    std::vector<Shape> Finish(Q quadric, std::initializer_list<float Q::*> lengths) {
        quadric.renderFromObject = a.renderFromObject;
        const float unit = Unit(quadric.radius);
        if (unit != 1) {
            for (float Q::*const length : lengths)
                quadric.*length /= unit;
            quadric.renderFromObject = a.renderFromObject * *Transform::Scale({unit, unit, unit});
        }
        if (Ok()) CheckSize(quadric.renderFromObject);
        if (!Ok()) return {};
        quadric.flipNormal = a.entity.reverseOrientation;
        return {Shape(quadric)};
    }

  private:
    /// What to measure a quadric of this radius in, so that squares of object space lengths neither
    /// over- nor underflow: a power of two, by which nothing else is changed.
    static float Unit(float radius) {
        return radius > 1e-6f && radius < 1e6f ? 1 : std::ldexp(1.f, std::ilogb(radius));
    }
    /// Normals and tangents must have lengths to normalise by.
    void CheckSize(const Transform &renderFromObject) {
        const Transform inverse = renderFromObject.Inverse();
        for (const Vector3f &axis : {Vector3f{1, 0, 0}, Vector3f{0, 1, 0}, Vector3f{0, 0, 1}})
            if (Ok() && !(HasSafeLength(renderFromObject.Vector(axis)) &&
                          HasSafeLength(inverse.Vector(axis))))
                Fail("", fmt::format("is {:g} in size where it stands; {:g} to {:g} can be traced",
                                     Length(renderFromObject.Vector(axis)), kShortestVector,
                                     kFarthest));
    }

    bool Ok() const { return a.params.Log().ErrorCount() == before; }

    const ShapeArguments &a;
    int before;  ///< errors of others
};

}  // namespace

std::vector<Shape> CreateSphere(const ShapeArguments &a) {
    QuadricReader reader(a);
    Sphere s;
    s.radius = reader.Radius();
    s.zMin = -s.radius;
    s.zMax = s.radius;
    reader.ZRange(&s.zMin, &s.zMax);
    if (s.zMin >= s.radius || s.zMax <= -s.radius)
        reader.Fail(kZMin.name,
                    fmt::format("zmin, {}, to zmax, {}, leaves nothing of the radius, {}", s.zMin,
                                s.zMax, s.radius));
    s.zMin = std::max(s.zMin, -s.radius);
    s.zMax = std::min(s.zMax, s.radius);
    s.phiMax = reader.PhiMax();
    return reader.Finish(s, {&Sphere::radius, &Sphere::zMin, &Sphere::zMax});
}

std::vector<Shape> CreateDisk(const ShapeArguments &a) {
    QuadricReader reader(a);
    Disk d;
    d.height = a.params.GetOneFloat(kHeight);
    d.radius = reader.Radius();
    d.innerRadius = a.params.GetOneFloat(kInnerRadius);
    if (!(d.innerRadius < d.radius))
        reader.Fail(kInnerRadius.name, fmt::format("\"float innerradius\": {} is outside [0, {})",
                                                   d.innerRadius, d.radius));
    d.phiMax = reader.PhiMax();
    return reader.Finish(d, {&Disk::radius, &Disk::innerRadius, &Disk::height});
}

std::vector<Shape> CreateCylinder(const ShapeArguments &a) {
    QuadricReader reader(a);
    Cylinder c;
    c.radius = reader.Radius();
    reader.ZRange(&c.zMin, &c.zMax);
    c.phiMax = reader.PhiMax();
    return reader.Finish(c, {&Cylinder::radius, &Cylinder::zMin, &Cylinder::zMax});
}

}  // namespace pbrt
