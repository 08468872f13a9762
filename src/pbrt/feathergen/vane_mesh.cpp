#include "pbrt/feathergen/vane_mesh.h"

#include <array>
#include <functional>
#include <numbers>

#include "pbrt/feathergen/vane_grid.h"

namespace pbrt::feathergen {
namespace {

struct Vertex {
    Point3f p;
    Normal3f n;
    Point2f uv;
};

uint32_t AddVertex(const Vertex &v, Mesh *mesh) {
    mesh->p.push_back(v.p);
    mesh->n.push_back(v.n);
    mesh->uv.push_back(v.uv);
    return uint32_t(mesh->p.size() - 1);
}

/// A bank's vertices, row after row.
std::vector<Vertex> BankVertices(const Feather &feather, const VaneGrid &grid, int barb,
                                 Bank bank) {
    std::vector<Vertex> vertices;
    vertices.reserve(size_t(grid.nAcross + 1) * size_t(grid.nAlong + 1));
    const int row0 = grid.AtlasRow(grid.BankIndex(barb, bank), 0);
    for (int j = 0; j <= grid.nAcross; ++j)
        for (int i = 0; i <= grid.nAlong; ++i) {
            const VanePoint point =
                feather.barbs[size_t(barb)].Surface(feather.parameters, grid.U(i), grid.V(bank, j));
            const Point2f atlas{float(double(i) / grid.nAlong),
                                float(double(row0 + j) / grid.AtlasRows())};
            vertices.push_back({Rounded(point.p), Rounded(point.Normal()), atlas});
        }
    return vertices;
}

/// Two triangles for corners 00 10 01 11.
void AddQuad(const std::array<uint32_t, 4> &corners, Mesh *mesh) {
    mesh->AddTriangle(corners[0], corners[1], corners[3]);
    mesh->AddTriangle(corners[0], corners[3], corners[2]);
}

void AddBank(const std::vector<Vertex> &vertices, const VaneGrid &grid, int bankIndex, VaneUV uv,
             Mesh *mesh) {
    const auto first = uint32_t(mesh->p.size());
    if (uv == VaneUV::Atlas)
        for (const Vertex &v : vertices)
            AddVertex(v, mesh);
    const int rowLength = grid.nAlong + 1;
    for (int j = 0; j < grid.nAcross; ++j)
        for (int i = 0; i < grid.nAlong; ++i) {
            std::array<uint32_t, 4> corners{};
            for (int k = 0; k < 4; ++k) {
                const auto at = uint32_t((j + k / 2) * rowLength + i + k % 2);
                Vertex v = vertices[at];
                v.uv = {float(k % 2), float(k / 2)};
                corners[size_t(k)] = uv == VaneUV::Atlas ? first + at : AddVertex(v, mesh);
            }
            AddQuad(corners, mesh);
            const int face = grid.Face(bankIndex, i, j);
            mesh->faces.insert(mesh->faces.end(), {face, face});
        }
}

/// A tube about `axis`, open at the ends, sunk by `sink` times its radius.
void AddTube(const BentAxis &axis, int nAlong, int nSides, double sink,
             const std::function<double(double)> &radiusAt, Mesh *mesh) {
    const auto first = uint32_t(mesh->p.size());
    for (int i = 0; i <= nAlong; ++i) {
        const double u = double(i) / nAlong, radius = radiusAt(u);
        const AxisFrame frame = axis.At(u);
        const Vec3d centre = axis.Point(u) - (sink * radius) * frame.up;
        for (int k = 0; k < nSides; ++k) {
            const double angle = 2 * std::numbers::pi * k / nSides;
            const Vec3d n = std::cos(angle) * frame.up - std::sin(angle) * frame.left;
            mesh->p.push_back(Rounded(centre + radius * n));
            mesh->n.push_back(Rounded(n));
        }
    }
    const auto at = [&](int i, int k) { return first + uint32_t(i * nSides + k % nSides); };
    for (int i = 0; i < nAlong; ++i)
        for (int k = 0; k < nSides; ++k)
            AddQuad({at(i, k + 1), at(i + 1, k + 1), at(i, k), at(i + 1, k)}, mesh);
}

}  // namespace

Mesh VaneMesh(const Feather &feather, Bank bank, VaneUV uv) {
    const VaneGrid grid(feather);
    Mesh mesh;
    for (int b = 0; b < grid.nBarbs; ++b)
        AddBank(BankVertices(feather, grid, b, bank), grid, grid.BankIndex(b, bank), uv, &mesh);
    return mesh;
}

Mesh RamusMesh(const Feather &feather) {
    const Parameters &p = feather.parameters;
    Mesh mesh;
    for (const Barb &barb : feather.barbs)
        AddTube(
            barb.axis, int(p.quadsAlong), int(p.tubeSides), 0.5,
            [&](double u) { return p.ramusRadius * (1 - 0.7 * u); }, &mesh);
    return mesh;
}

Mesh RachisMesh(const Feather &feather) {
    const Parameters &p = feather.parameters;
    Mesh mesh;
    AddTube(
        feather.rachis, int(p.rachisSegments), int(2 * p.tubeSides), 0.3,
        [&](double u) { return feather.RachisRadius(u); }, &mesh);
    return mesh;
}

}  // namespace pbrt::feathergen
