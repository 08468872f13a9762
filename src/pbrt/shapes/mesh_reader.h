#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "pbrt/base/shape.h"
#include "pbrt/shapes/place_mesh.h"

namespace pbrt {

/// Reads what meshes have in common and reports what does not fit.
class MeshReader {
  public:
    static constexpr ArrayParam kP{"P", "point3", "an error", "vertices"};
    static constexpr ArrayParam kIndices{
        "indices", "integer", "one face: the vertices in order",
        "the vertices of each face, from 0: 3 a triangle, 4 a patch"};
    static constexpr ArrayParam kN{"N", "normal", "the faces' own",
                                   "shading normal of each vertex"};
    static constexpr ArrayParam kS{"S", "vector3", "along u", "tangent of each vertex"};
    static constexpr ArrayParam kUV{"uv", "point2", "each face's corners",
                                    "surface coordinates of each vertex"};
    static constexpr ArrayParam kFaceIndices{"faceIndices", "integer", "the face's number",
                                             "number of each face, for textures"};

    MeshReader(const ShapeArguments &a, int corners) : a(a), params(a.params), corners(corners) {}

    /// "P" and "indices"; false after an error.
    bool PointsAndIndices(std::vector<Point3f> *p, std::vector<uint32_t> *indices);

    /// An optional array; its length must be `count`.
    template <typename T>
    void Check(const ArrayParam &row, std::string_view of, size_t count,
               const std::vector<T> &values) {
        CheckCount(row, of, count, values.size());
    }

    /// The mesh in rendering space, or nothing after an error.
    template <typename Mesh>
    std::optional<Mesh> Finish(Mesh mesh) {
        if (!ok) return {};
        if (const auto wrong = PlaceMesh(a.renderFromObject, a.entity.reverseOrientation, &mesh)) {
            Fail("", params.What() + ": " + *wrong);
            return {};
        }
        return mesh;
    }

  private:
    void CheckCount(const ArrayParam &row, std::string_view of, size_t count, size_t values);
    bool Fail(std::string_view name, std::string_view message);

    const ShapeArguments &a;
    ParamDict &params;
    int corners;
    bool ok = true;
};

}  // namespace pbrt
