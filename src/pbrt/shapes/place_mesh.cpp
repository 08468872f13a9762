#include "pbrt/shapes/place_mesh.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/base/ray_tracer.h"
#include "pbrt/shapes/bilinear_mesh.h"
#include "pbrt/shapes/triangle_mesh.h"

namespace pbrt {
namespace {

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

/// Moves points and normals.
template <typename Mesh>
std::optional<std::string> PlaceCommon(const Transform &t, bool reverse, Mesh *mesh) {
    mesh->p.reserve(mesh->p.size() + kPointsBehindLast);
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

}  // namespace pbrt
