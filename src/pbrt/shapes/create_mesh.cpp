#include <fmt/format.h>

#include <cmath>

#include "pbrt/shapes/bilinear.h"
#include "pbrt/shapes/create.h"

namespace pbrt {
namespace {

constexpr ArrayParam kP{"P", "point3", "an error", "vertices"};
constexpr ArrayParam kIndices{"indices", "integer", "one face: the vertices in order",
                              "the vertices of each face, from 0: 3 a triangle, 4 a patch"};
constexpr ArrayParam kN{"N", "normal", "the faces' own", "shading normal of each vertex"};
constexpr ArrayParam kS{"S", "vector3", "along u", "tangent of each vertex"};
constexpr ArrayParam kUV{"uv", "point2", "each face's corners",
                         "surface coordinates of each vertex"};
constexpr ArrayParam kFaceIndices{"faceIndices", "integer", "the face's number",
                                  "number of each face, for textures"};

/// Reads what the two meshes have in common and reports what does not fit.
class MeshReader {
  public:
    MeshReader(const ShapeArguments &a, int corners) : params(a.params), corners(corners) {}

    bool PointsAndIndices(std::vector<Point3f> *p, std::vector<uint32_t> *indices) {
        *p = params.GetPoint3fArray(kP);
        const std::vector<int> given = params.GetIntArray(kIndices);
        if (p->empty()) return Fail("", fmt::format("{} needs \"point3 P\"", params.What()));
        if (given.empty() && p->size() != size_t(corners))
            return Fail("", fmt::format("{} needs \"integer indices\", for it has {} points and "
                                        "not {}",
                                        params.What(), p->size(), corners));
        if (given.size() % corners != 0)
            return Fail("indices", fmt::format("\"integer indices\": {} values are not a multiple "
                                               "of {}",
                                               given.size(), corners));
        for (size_t i = 0; i < given.size(); ++i)
            if (given[i] < 0 || size_t(given[i]) >= p->size())
                return Fail("indices",
                            fmt::format("\"integer indices\": value {} is {}, but \"P\" has {} "
                                        "points (0 to {})",
                                        i, given[i], p->size(), p->size() - 1));
        indices->assign(given.begin(), given.end());
        for (int i = 0; given.empty() && i < corners; ++i)
            indices->push_back(uint32_t(i));
        return true;
    }

    /// An optional array; its length must be `count`.
    template <typename T>
    void Check(const ArrayParam &row, std::string_view of, size_t count,
               const std::vector<T> &values) {
        if (!values.empty() && values.size() != count)
            Fail(row.name, fmt::format("\"{} {}\": {} values for {} {}", row.type, row.name,
                                       values.size(), count, of));
    }

    bool Fail(std::string_view name, std::string_view message) {
        if (name.empty())
            params.Error(message);
        else
            params.Error(name, message);
        return ok = false;
    }
    bool Ok() const { return ok; }

  private:
    ParamDict &params;
    int corners;
    bool ok = true;
};

template <typename Mesh>
std::vector<Shape> Finish(const ShapeArguments &a, Mesh mesh) {
    const auto wrong = PlaceMesh(a.renderFromObject, a.entity.reverseOrientation, &mesh);
    if (wrong) {
        a.params.Error(fmt::format("{}: {}", a.params.What(), *wrong));
        return {};
    }
    std::vector<Shape> shapes;
    shapes.emplace_back(std::move(mesh));
    return shapes;
}

bool IsFinite(Vector3f v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A power of two that makes what the transform does to normals neither over- nor underflow where
/// they are normalised.
float NormalScale(const Transform &t) {
    float most = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            most = std::max(most, std::abs(t.InverseMatrix()[i][j]));
    return most > 1e-6f && most < 1e6f ? 1 : std::ldexp(1.f, -std::ilogb(most));
}

/// Moves points and normals. Embree reads 16 bytes for the last vertex of 12.
template <typename Mesh>
std::optional<std::string> PlaceCommon(const Transform &t, bool reverse, Mesh *mesh) {
    mesh->p.reserve(mesh->p.size() + 1);
    for (size_t i = 0; i < mesh->p.size(); ++i) {
        const Point3f before = mesh->p[i];
        mesh->p[i] = t.Point(before);
        if (!IsFinite(mesh->p[i]))
            return fmt::format("point {} is not finite: ({}, {}, {}) placed at ({}, {}, {})", i,
                               before.x, before.y, before.z, mesh->p[i].x, mesh->p[i].y,
                               mesh->p[i].z);
    }
    const float normalScale = NormalScale(t);
    for (size_t i = 0; i < mesh->n.size(); ++i) {
        if (!IsFinite(mesh->n[i])) return fmt::format("normal {} is not finite", i);
        // Not normalised: so instances, transformed after interpolation, look like copies.
        const Normal3f n = t.Normal(normalScale * mesh->n[i]);
        mesh->n[i] = reverse ? -n : n;
    }
    for (size_t i = 0; i < mesh->uv.size(); ++i)
        if (!std::isfinite(mesh->uv[i].x) || !std::isfinite(mesh->uv[i].y))
            return fmt::format("uv {} is not finite", i);
    mesh->flipNormal = reverse != t.SwapsHandedness();
    return {};
}

/// Flat to 1e-6 of its size and strictly convex, so that the two triangles cover what the bilinear
/// map covers, and the map can be inverted everywhere.
bool IsPlanar(const Patch &q) {
    const Vector3f e10 = q.p10 - q.p00, e01 = q.p01 - q.p00, f01 = q.p11 - q.p10,
                   f10 = q.p11 - q.p01;
    const Vector3f corners[4] = {Cross(e10, e01), Cross(e10, f01), Cross(f10, e01),
                                 Cross(f10, f01)};
    const Vector3f sum = corners[0] + corners[1] + corners[2] + corners[3];
    const Vector3f n = UnitOr(sum, {});
    const float size = std::max(Length(q.p11 - q.p00), Length(q.p10 - q.p01));
    for (const Vector3f &c : corners)
        if (!(Dot(c, n) > 1e-3f * size * size)) return false;
    return AbsDot(n, q.p11 - q.p00) <= 1e-6f * size && AbsDot(n, e10) <= 1e-6f * size &&
           AbsDot(n, e01) <= 1e-6f * size;
}

}  // namespace

std::optional<std::string> PlaceMesh(const Transform &renderFromObject, bool reverseOrientation,
                                     TriangleMesh *mesh) {
    if (auto wrong = PlaceCommon(renderFromObject, reverseOrientation, mesh)) return wrong;
    for (size_t i = 0; i < mesh->s.size(); ++i) {
        mesh->s[i] = renderFromObject.Vector(mesh->s[i]);
        if (!IsFinite(mesh->s[i])) return fmt::format("tangent {} is not finite", i);
    }
    return {};
}

std::optional<std::string> PlaceMesh(const Transform &renderFromObject, bool reverseOrientation,
                                     BilinearMesh *mesh) {
    if (auto wrong = PlaceCommon(renderFromObject, reverseOrientation, mesh)) return wrong;
    mesh->planar = true;
    for (size_t i = 0; i < mesh->NPrimitives() && mesh->planar; ++i)
        mesh->planar = IsPlanar(GetPatch(*mesh, uint32_t(i)));
    return {};
}

std::vector<Shape> CreateTriangleMesh(const ShapeArguments &a) {
    MeshReader reader(a, 3);
    TriangleMesh mesh;
    mesh.n = a.params.GetNormalArray(kN);
    mesh.s = a.params.GetVector3fArray(kS);
    mesh.uv = a.params.GetPoint2fArray(kUV);
    mesh.faceIndices = a.params.GetIntArray(kFaceIndices);
    if (!reader.PointsAndIndices(&mesh.p, &mesh.indices)) return {};
    reader.Check(kN, "points", mesh.p.size(), mesh.n);
    reader.Check(kS, "points", mesh.p.size(), mesh.s);
    reader.Check(kUV, "points", mesh.p.size(), mesh.uv);
    reader.Check(kFaceIndices, "triangles", mesh.NPrimitives(), mesh.faceIndices);
    if (!reader.Ok()) return {};
    return Finish(a, std::move(mesh));
}

std::vector<Shape> CreateBilinearMesh(const ShapeArguments &a) {
    MeshReader reader(a, 4);
    BilinearMesh mesh;
    mesh.n = a.params.GetNormalArray(kN);
    mesh.uv = a.params.GetPoint2fArray(kUV);
    mesh.faceIndices = a.params.GetIntArray(kFaceIndices);
    if (!reader.PointsAndIndices(&mesh.p, &mesh.indices)) return {};
    reader.Check(kN, "points", mesh.p.size(), mesh.n);
    reader.Check(kUV, "points", mesh.p.size(), mesh.uv);
    reader.Check(kFaceIndices, "patches", mesh.NPrimitives(), mesh.faceIndices);
    if (!reader.Ok()) return {};
    return Finish(a, std::move(mesh));
}

}  // namespace pbrt
