#include "pbrt/shapes/bilinear_mesh.h"

#include "pbrt/shapes/mesh_reader.h"
#include "pbrt/shapes/patch_intersection.h"
#include "pbrt/shapes/patch_sampler.h"

namespace pbrt {
namespace {

// Area lights sample a patch without it: noisier where the picture is uneven, and right.
constexpr StringParam kEmission{"emissionfilename", "",
                                "guides how pbrt-v4 samples lights; without effect here"};

}  // namespace

std::optional<BilinearMesh> BilinearMesh::Create(const ShapeArguments &a) {
    MeshReader reader(a, 4);
    BilinearMesh mesh;
    mesh.n = a.params.GetNormalArray(MeshReader::kN);
    mesh.uv = a.params.GetPoint2fArray(MeshReader::kUV);
    mesh.faceIndices = a.params.GetIntArray(MeshReader::kFaceIndices);
    a.params.GetFileName(kEmission);
    if (!reader.PointsAndIndices(&mesh.p, &mesh.indices)) return {};
    reader.Check(MeshReader::kN, "points", mesh.p.size(), mesh.n);
    reader.Check(MeshReader::kUV, "points", mesh.p.size(), mesh.uv);
    reader.Check(MeshReader::kFaceIndices, "patches", mesh.NPrimitives(), mesh.faceIndices);
    return reader.Finish(std::move(mesh));
}

Bounds3f BilinearMesh::Bounds() const {
    Bounds3f b;
    for (const uint32_t i : indices)
        b.Grow(p[i]);
    return b;
}

Bounds3f BilinearMesh::PrimitiveBounds(uint32_t primitive) const {
    Bounds3f b;
    for (size_t i = 0; i < 4; ++i)
        b.Grow(p[indices[4 * size_t(primitive) + i]]);
    return b;
}

std::optional<PrimitiveHit> BilinearMesh::Intersect(uint32_t primitive, const RayD &ray) const {
    return IntersectPatch(GetPatch(*this, primitive), ray);
}

float BilinearMesh::Area(uint32_t primitive) const {
    return PatchSampler(*this, primitive).Area();
}
std::optional<ShapeSample> BilinearMesh::SampleArea(uint32_t primitive, Point2f u) const {
    return PatchSampler(*this, primitive).SampleArea(u);
}
std::optional<ShapeSample> BilinearMesh::SampleFrom(uint32_t primitive, Point3f ref,
                                                    Point2f u) const {
    return PatchSampler(*this, primitive).SampleFrom(ref, u);
}
float BilinearMesh::PDFFrom(uint32_t primitive, Point3f ref, Point3f p, Normal3f n) const {
    return PatchSampler(*this, primitive).PDFFrom(ref, p, n);
}
NormalCone BilinearMesh::NormalBounds(uint32_t primitive) const {
    return PatchSampler(*this, primitive).Normals();
}

}  // namespace pbrt
