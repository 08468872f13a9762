#include "pbrt/shapes/displacement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

/// Means of their triangles' normals, by area; 0 where there is none.
std::vector<Normal3f> VertexNormals(const TriangleMesh &mesh) {
    std::vector<Normal3f> normals(mesh.p.size());
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Point3f a = mesh.p[mesh.indices[i]];
        const Normal3f n = Cross(mesh.p[mesh.indices[i + 1]] - a, mesh.p[mesh.indices[i + 2]] - a);
        for (size_t k = 0; k < 3; ++k)
            normals[mesh.indices[i + k]] += n;
    }
    for (Normal3f &n : normals)
        n = UnitOr(n, {});
    return normals;
}

/// One round of cutting: every edge that is too long in its middle, so that neighbours stay joined.
class Cutter {
  public:
    Cutter(TriangleMesh *mesh, const Transform &renderFromObject, float edgeLength)
        : mesh(*mesh), renderFromObject(renderFromObject), edgeLength(edgeLength) {}

    /// False where no edge was too long.
    bool Cut() {
        std::vector<uint32_t> before;
        before.swap(mesh.indices);
        std::vector<int> faces;
        faces.swap(mesh.faceIndices);
        for (size_t i = 0; i < before.size(); i += 3) {
            CutTriangle({before[i], before[i + 1], before[i + 2]});
            mesh.faceIndices.resize(mesh.indices.size() / 3, faces[i / 3]);
        }
        return !middles.empty();
    }

  private:
    static constexpr uint32_t kNone = ~uint32_t(0);

    void CutTriangle(std::array<uint32_t, 3> v) {
        std::array<uint32_t, 3> m;  // of the edges from v[i]
        for (size_t i = 0; i < 3; ++i)
            m[i] = MiddleOf(v[i], v[(i + 1) % 3]);
        const auto cuts = std::count_if(m.begin(), m.end(), [](uint32_t i) { return i != kNone; });
        // Turned so that one cut is of the first edge, and of two the last edge is whole.
        const auto isTurned = [&] {
            return cuts == 2 ? m[2] == kNone : cuts != 1 || m[0] != kNone;
        };
        while (!isTurned()) {
            std::rotate(v.begin(), v.begin() + 1, v.end());
            std::rotate(m.begin(), m.begin() + 1, m.end());
        }
        if (cuts == 0)
            Add({v[0], v[1], v[2]});
        else if (cuts == 1)
            Add({v[0], m[0], v[2], m[0], v[1], v[2]});
        else if (cuts == 2)
            Add({m[0], v[1], m[1], v[0], m[0], m[1], v[0], m[1], v[2]});
        else
            Add({v[0], m[0], m[2], m[0], v[1], m[1], m[2], m[1], v[2], m[0], m[1], m[2]});
    }
    void Add(std::initializer_list<uint32_t> triangles) {
        mesh.indices.insert(mesh.indices.end(), triangles);
    }
    uint32_t MiddleOf(uint32_t a, uint32_t b) {
        const float length = Length(renderFromObject.Vector(mesh.p[b] - mesh.p[a]));
        if (!(length > edgeLength)) return kNone;
        const Point3f middle = 0.5f * (mesh.p[a] + mesh.p[b]);
        // Far from the origin floats may have no middle.
        for (const uint32_t end : {a, b})
            if (!(Length(renderFromObject.Vector(mesh.p[end] - middle)) < 0.75f * length))
                return kNone;
        const auto [lower, upper] = std::minmax(a, b);
        const auto [known, isNew] =
            middles.try_emplace(uint64_t(lower) << 32 | upper, uint32_t(mesh.p.size()));
        if (isNew) {
            mesh.p.push_back(middle);
            mesh.n.push_back(UnitOr(mesh.n[a] + mesh.n[b], mesh.n[a]));
            mesh.uv.push_back(0.5f * (mesh.uv[a] + mesh.uv[b]));
        }
        return known->second;
    }

    TriangleMesh &mesh;
    const Transform &renderFromObject;
    float edgeLength;
    std::unordered_map<uint64_t, uint32_t> middles;
};

/// Why the mesh cannot be cut so finely; empty where it can.
std::string TooFine(const TriangleMesh &mesh, const Transform &renderFromObject, float edgeLength) {
    // Each round halves edges; thin triangles end up as a little fewer or more than this.
    double triangles = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        float longest = 0;
        for (size_t k = 0; k < 3; ++k) {
            const Vector3f edge =
                mesh.p[mesh.indices[i + (k + 1) % 3]] - mesh.p[mesh.indices[i + k]];
            longest = std::max(longest, Length(renderFromObject.Vector(edge)));
        }
        triangles += std::exp2(2 * std::max(0.f, std::ceil(std::log2(longest / edgeLength))));
    }
    constexpr double kMost = 0x1p28, kBytes = 100;  // a triangle, half a vertex, their edges
    std::string why;
    if (!(triangles <= kMost))
        why = "more than fit here";
    else if (const auto tooLarge = WhyTooLarge(uint64_t(triangles * kBytes)))
        why = "which " + *tooLarge;
    if (why.empty()) return why;
    return fmt::format("\"edgelength\" {:g} makes about {:.3g} triangles, {}", edgeLength,
                       triangles, why);
}

}  // namespace

std::optional<std::string> Displace(const FloatTexture &height, float edgeLength,
                                    const Transform &renderFromObject, TriangleMesh *mesh) {
    if (mesh->uv.empty()) return "has no uv, by which \"displacement\" is looked up";
    const std::vector<Normal3f> ofFaces = VertexNormals(*mesh);
    mesh->n.resize(mesh->p.size());
    for (size_t i = 0; i < mesh->n.size(); ++i)
        mesh->n[i] = UnitOr(mesh->n[i], ofFaces[i]);
    if (mesh->faceIndices.empty())
        for (size_t i = 0; i < mesh->NPrimitives(); ++i)
            mesh->faceIndices.push_back(int(i));
    if (const std::string why = TooFine(*mesh, renderFromObject, edgeLength); !why.empty())
        return why;
    while (Cutter(mesh, renderFromObject, edgeLength).Cut())
        continue;
    for (size_t i = 0; i < mesh->p.size(); ++i) {
        TextureEvalContext ctx;
        ctx.p = renderFromObject.Point(mesh->p[i]);
        ctx.n = UnitOr(renderFromObject.Normal(mesh->n[i]), {});
        ctx.uv = mesh->uv[i];
        mesh->p[i] = mesh->p[i] + height.Evaluate(ctx) * mesh->n[i];
    }
    // Normals may have been given on the other side than the triangles'.
    const std::vector<Normal3f> displaced = VertexNormals(*mesh);
    for (size_t i = 0; i < mesh->n.size(); ++i)
        mesh->n[i] = Dot(displaced[i], mesh->n[i]) < 0 ? -displaced[i] : displaced[i];
    return {};
}

}  // namespace pbrt
