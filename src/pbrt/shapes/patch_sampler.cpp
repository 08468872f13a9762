#include "pbrt/shapes/patch_sampler.h"

namespace pbrt {

ShapeSample PatchSampler::At(Point2f uv, float pdf) const {
    const uint32_t *i = PatchIndices(mesh, primitive);
    const BilinearWeights w(uv);
    ShapeSample s;
    s.p = w(patch);
    s.pError = Gamma(9) * w(Abs(patch.p00), Abs(patch.p10), Abs(patch.p01), Abs(patch.p11));
    // Traversal's triangles and the bilinear surface differ by what counts as flat.
    const Vector3f diagonal = patch.p11 - patch.p00;
    s.n = PatchNormal(patch, patch.DpDu(uv.y), patch.DpDv(uv.x));
    if (mesh.planar) s.pError += (1e-6f * Length(diagonal)) * Abs(s.n);
    if (mesh.flipNormal) s.n = -s.n;
    if (!mesh.n.empty())
        s.n = FaceForward(s.n, w(mesh.n[i[0]], mesh.n[i[1]], mesh.n[i[2]], mesh.n[i[3]]));
    s.uv = mesh.uv.empty() ? uv : w(mesh.uv[i[0]], mesh.uv[i[1]], mesh.uv[i[2]], mesh.uv[i[3]]);
    s.pdf = pdf;
    return s;
}

/// Gauss's rule with 4 x 4 nodes; exact for flat patches.
float PatchSampler::Area() const {
    constexpr float kNode[2] = {0.33998104358485626f, 0.86113631159405258f};
    constexpr float kWeight[2] = {0.65214515486254614f, 0.34785484513745386f};
    const auto node = [&](int i) { return 0.5f + (i & 1 ? 0.5f : -0.5f) * kNode[i >> 1]; };
    float sum = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            sum += kWeight[i >> 1] * kWeight[j >> 1] *
                   Length(Cross(patch.DpDu(node(j)), patch.DpDv(node(i))));
    return sum / 4;
}

/// cross(dpdu, dpdv) is linear in u and in v: every normal is a positive combination of the
/// corners', and lies in a cone (of less than a half space) that holds these.
NormalCone PatchSampler::Normals() const {
    const Vector3f e10 = patch.p10 - patch.p00, e01 = patch.p01 - patch.p00,
                   f01 = patch.p11 - patch.p10, f10 = patch.p11 - patch.p01;
    const Normal3f n[4] = {UnitOr(Cross(e10, e01), {}), UnitOr(Cross(e10, f01), {}),
                           UnitOr(Cross(f10, e01), {}), UnitOr(Cross(f10, f01), {})};
    const Vector3f axis = UnitOr(n[0] + n[1] + n[2] + n[3], {0, 0, 1});
    float cosTheta = 1;
    for (const Normal3f &corner : n)
        if (LengthSquared(corner) > 0) cosTheta = std::min(cosTheta, Dot(axis, corner));
    const NormalCone all{axis, -1};
    if (cosTheta <= 1e-3f) return all;
    const uint32_t *i = PatchIndices(mesh, primitive);
    float turned = mesh.flipNormal ? -1 : 1;
    if (!mesh.n.empty()) {
        // Per-vertex normals decide the side; sure only where all agree with all corners' normals.
        int agree = 0;
        for (int k = 0; k < 4; ++k)
            for (const Normal3f &corner : n) {
                const float d = Dot(mesh.n[i[k]], corner);
                agree += (d > 0) - (d < 0);
            }
        if (std::abs(agree) != 16) return all;
        turned = agree < 0 ? -1 : 1;
    }
    return {turned * axis, cosTheta};
}

}  // namespace pbrt
