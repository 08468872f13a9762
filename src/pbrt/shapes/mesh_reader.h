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
    MeshReader(const ShapeArguments &a, int corners) : a(a), params(a.params), corners(corners) {}

    /// "P" and "indices"; false after an error.
    bool PointsAndIndices(std::vector<Point3f> *p, std::vector<uint32_t> *indices);

    /// An optional array; its length must be `count`.
    template <typename T>
    void Check(std::string_view type, std::string_view name, std::string_view of, size_t count,
               const std::vector<T> &values) {
        CheckCount(type, name, of, count, values.size());
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
    void CheckCount(std::string_view type, std::string_view name, std::string_view of, size_t count,
                    size_t values);
    bool Fail(std::string_view name, std::string_view message);

    const ShapeArguments &a;
    ParamDict &params;
    int corners;
    bool ok = true;
};

}  // namespace pbrt
