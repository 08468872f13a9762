#include "pbrt/shapes/triangle_mesh.h"

#include "pbrt/shapes/mesh_reader.h"
#include "pbrt/shapes/triangle_sampler.h"

namespace pbrt {

std::optional<TriangleMesh> TriangleMesh::Create(const ShapeArguments &a) {
    MeshReader reader(a, 3);
    TriangleMesh mesh;
    mesh.n = a.params.GetNormalArray(MeshReader::kN);
    mesh.s = a.params.GetVector3fArray(MeshReader::kS);
    mesh.uv = a.params.GetPoint2fArray(MeshReader::kUV);
    mesh.faceIndices = a.params.GetIntArray(MeshReader::kFaceIndices);
    if (!reader.PointsAndIndices(&mesh.p, &mesh.indices)) return {};
    reader.Check(MeshReader::kN, "points", mesh.p.size(), mesh.n);
    reader.Check(MeshReader::kS, "points", mesh.p.size(), mesh.s);
    reader.Check(MeshReader::kUV, "points", mesh.p.size(), mesh.uv);
    reader.Check(MeshReader::kFaceIndices, "triangles", mesh.NPrimitives(), mesh.faceIndices);
    return reader.Finish(std::move(mesh));
}

Bounds3f TriangleMesh::Bounds() const {
    Bounds3f b;
    for (const uint32_t i : indices)
        b.Grow(p[i]);
    return b;
}

Bounds3f TriangleMesh::PrimitiveBounds(uint32_t primitive) const {
    Bounds3f b;
    for (size_t i = 0; i < 3; ++i)
        b.Grow(p[indices[3 * size_t(primitive) + i]]);
    return b;
}

float TriangleMesh::Area(uint32_t primitive) const {
    return TriangleSampler(*this, primitive).Area();
}
std::optional<ShapeSample> TriangleMesh::SampleArea(uint32_t primitive, Point2f u) const {
    return TriangleSampler(*this, primitive).SampleArea(u);
}
std::optional<ShapeSample> TriangleMesh::SampleFrom(uint32_t primitive, Point3f ref,
                                                    Point2f u) const {
    return TriangleSampler(*this, primitive).SampleFrom(ref, u);
}
float TriangleMesh::PDFFrom(uint32_t primitive, Point3f ref, Point3f p, Normal3f n) const {
    return TriangleSampler(*this, primitive).PDFFrom(ref, p, n);
}
NormalCone TriangleMesh::NormalBounds(uint32_t primitive) const {
    return TriangleSampler(*this, primitive).Normals();
}

}  // namespace pbrt
