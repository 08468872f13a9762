#include "pbrt/feathergen/neck_surface.h"

#include <algorithm>
#include <numbers>

#include "pbrt/shapes/ply.h"
#include "pbrt/util/rng.h"

namespace pbrt::feathergen {
namespace {

Vec3d ToDouble(Vector3f v) {
    return {v.x, v.y, v.z};
}

/// Point of the built-in neck, t from head to breast.
Vec3d NeckPoint(double t, double phi) {
    // Nowhere hollow along the flow: stiff feathers would stand off.
    const double radius = 13 + 14 * std::sin(0.5 * std::numbers::pi * t);
    return {radius * std::cos(phi), 1.08 * radius * std::sin(phi) - 8 * t, -68 * t};
}

void SetNormals(Mesh *mesh) {
    mesh->n.assign(mesh->p.size(), {});
    for (size_t i = 0; i < mesh->indices.size(); i += 3) {
        const uint32_t *k = &mesh->indices[i];
        const Vector3f area = Cross(mesh->p[k[1]] - mesh->p[k[0]], mesh->p[k[2]] - mesh->p[k[0]]);
        for (int j = 0; j < 3; ++j)
            mesh->n[k[j]] += area;
    }
    for (Normal3f &n : mesh->n)
        n = LengthSquared(n) > 0 ? Normalize(n) : Normal3f{0, 0, 1};
}

}  // namespace

Mesh BuiltInNeck() {
    constexpr int kAlong = 96, kRound = 128;
    Mesh mesh;
    for (int i = 0; i <= kAlong; ++i)
        for (int k = 0; k < kRound; ++k) {
            const Vec3d p = NeckPoint(double(i) / kAlong, 2 * std::numbers::pi * k / kRound);
            mesh.p.push_back(Rounded(p));
        }
    const auto at = [&](int i, int k) { return uint32_t(i * kRound + k % kRound); };
    for (int i = 0; i < kAlong; ++i)
        for (int k = 0; k < kRound; ++k) {
            mesh.AddTriangle(at(i, k), at(i + 1, k), at(i + 1, k + 1));
            mesh.AddTriangle(at(i, k), at(i + 1, k + 1), at(i, k + 1));
        }
    SetNormals(&mesh);
    return mesh;
}

std::optional<Mesh> ReadSurface(const std::string &fileName, std::string *problem) {
    std::optional<PlyMesh> ply = ReadPly(fileName, problem);
    if (!ply) {
        *problem = fileName + ": " + *problem;
        return {};
    }
    Mesh mesh;
    mesh.p = std::move(ply->p);
    mesh.n = std::move(ply->n);
    mesh.indices = std::move(ply->triangles);
    for (size_t i = 0; i < ply->quads.size(); i += 4) {
        const uint32_t *q = &ply->quads[i];
        mesh.AddTriangle(q[0], q[1], q[3]);
        mesh.AddTriangle(q[0], q[3], q[2]);
    }
    if (mesh.n.empty()) SetNormals(&mesh);
    return mesh;
}

std::vector<SurfaceSample> SampleSurface(const Mesh &mesh, Vec3d flow, size_t count,
                                         uint64_t seed) {
    std::vector<double> areas;
    double total = 0, begin = Infinity, end = -Infinity;
    for (const Point3f &p : mesh.p) {
        begin = std::min(begin, Dot(ToDouble(p), flow));
        end = std::max(end, Dot(ToDouble(p), flow));
    }
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const uint32_t *k = &mesh.indices[i];
        total += Length(Cross(mesh.p[k[1]] - mesh.p[k[0]], mesh.p[k[2]] - mesh.p[k[0]])) / 2;
        areas.push_back(total);
    }
    std::vector<SurfaceSample> samples;
    if (!(total > 0 && total < Infinity && end > begin)) return samples;
    Rng rng(seed);
    while (samples.size() < count) {
        const double area = double(rng.Uniform()) * total;
        const auto found = std::upper_bound(areas.begin(), areas.end() - 1, area);
        const uint32_t *k = &mesh.indices[3 * size_t(found - areas.begin())];
        const double root = std::sqrt(double(rng.Uniform())), split = double(rng.Uniform());
        const double w[3] = {1 - root, root * (1 - split), root * split};
        SurfaceSample s{};
        for (int j = 0; j < 3; ++j) {
            s.p += w[j] * ToDouble(mesh.p[k[j]]);
            s.n += w[j] * ToDouble(mesh.n[k[j]]);
        }
        if (!(LengthSquared(s.n) > 0)) s.n = {0, 0, 1};
        s.n = Normalize(s.n);
        s.along = (Dot(s.p, flow) - begin) / (end - begin);
        samples.push_back(s);
    }
    return samples;
}

}  // namespace pbrt::feathergen
