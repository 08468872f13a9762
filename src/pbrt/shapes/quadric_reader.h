#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "pbrt/base/shape.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// Reads the parameters that quadrics share, each with its check.
class QuadricReader {
  public:
    explicit QuadricReader(const ShapeArguments &a);

    static constexpr FloatParam kRadius{"radius",   "",    1,
                                        kAboveZero, kOpen, "distance of the surface"};
    static constexpr FloatParam kZMin{"zmin", "",    -1,
                                      -kOpen, kOpen, "lower cut; a sphere's default: -radius"};
    static constexpr FloatParam kZMax{"zmax", "",    1,
                                      -kOpen, kOpen, "upper cut; a sphere's default: radius"};
    static constexpr FloatParam kPhiMax{
        "phimax", "deg", 360, kAboveZero, 360, "how far the surface goes round the z axis"};

    float Radius() { return Float(kRadius); }
    /// In radians, (0, 2 pi].
    float PhiMax();
    /// zmin < zmax; given are the defaults.
    void ZRange(float *zMin, float *zMax);
    float Float(const FloatParam &row) { return a.params.GetOneFloat(row); }
    /// At least 0 and less than another length, which the row does not know.
    float FloatBelow(const FloatParam &row, float limit);

    /// An error at the named parameter; without a name at the directive, after the shape's name.
    void Fail(std::string_view name, std::string_view message);

    /// The quadric with its transform, or nothing after an error. `lengths`: all that it has.
    template <typename Q>
    std::optional<Q> Finish(Q quadric, std::initializer_list<float Q::*> lengths) {
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
        return quadric;
    }

  private:
    /// Unit of length for a quadric of this radius in which squares of object space lengths neither
    /// over- nor underflow: a power of two, which changes nothing else.
    static float Unit(float radius);
    /// Normals and tangents must have lengths to normalise by.
    void CheckSize(const Transform &renderFromObject);

    bool Ok() const { return a.params.Log().ErrorCount() == before; }

    const ShapeArguments &a;
    int before;  ///< errors of others
};

}  // namespace pbrt
