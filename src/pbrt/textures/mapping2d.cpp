#include "pbrt/textures/mapping2d.h"

#include <array>

namespace pbrt {
namespace {

/// Chain rule with the gradients of s and t in texture space.
TexCoord2D WithGradients(Point2f st, Vector3f dsdp, Vector3f dtdp, const Transform &tr,
                         const TextureEvalContext &ctx) {
    const Vector3f dpdx = tr.Vector(ctx.dpdx), dpdy = tr.Vector(ctx.dpdy);
    return {st, Dot(dsdp, dpdx), Dot(dsdp, dpdy), Dot(dtdp, dpdx), Dot(dtdp, dpdy)};
}

/// Gradient of phi / (2 pi) about the z axis; 0 on it.
Vector3f TurnGradient(Point3f p) {
    const float r2 = Sqr(p.x) + Sqr(p.y);
    if (r2 == 0) return {};
    return Vector3f{-p.y, p.x, 0} * (1 / (2 * Pi * r2));
}

}  // namespace

TexCoord2D SphericalMapping::Map(const TextureEvalContext &ctx) const {
    const Point3f p = textureFromRender.Point(ctx.p);
    const float r = std::sqrt(Sqr(p.x) + Sqr(p.y));
    const float d2 = Sqr(r) + Sqr(p.z);
    const float turn = std::atan2(p.y, p.x) / (2 * Pi);
    const Point2f st{std::atan2(r, p.z) / Pi, turn < 0 ? turn + 1 : turn};
    // d theta = (z dr - r dz) / (r^2 + z^2)
    const Vector3f dsdp =
        r == 0 ? Vector3f{} : Vector3f{p.z * p.x / r, p.z * p.y / r, -r} * (1 / (Pi * d2));
    return WithGradients(st, dsdp, TurnGradient(p), textureFromRender, ctx);
}

TexCoord2D CylindricalMapping::Map(const TextureEvalContext &ctx) const {
    const Point3f p = textureFromRender.Point(ctx.p);
    const Point2f st{(Pi + std::atan2(p.y, p.x)) / (2 * Pi), p.z};
    return WithGradients(st, TurnGradient(p), {0, 0, 1}, textureFromRender, ctx);
}

TexCoord2D PlanarMapping::Map(const TextureEvalContext &ctx) const {
    const Point3f p = textureFromRender.Point(ctx.p);
    return WithGradients({Dot(p, v1) + uDelta, Dot(p, v2) + vDelta}, v1, v2, textureFromRender,
                         ctx);
}

TextureMapping2D TextureMapping2D::Create(ParamDict &params, const Transform &textureFromRender) {
    static constexpr std::array<std::string_view, 4> kNames{"uv", "spherical", "cylindrical",
                                                            "planar"};
    switch (params.GetOneChoice("mapping", kNames[0], kNames)) {
        case 1:
            return SphericalMapping{textureFromRender};
        case 2:
            return CylindricalMapping{textureFromRender};
        case 3: {
            const Vector3f v1 = params.GetOneVector3f("v1", {1, 0, 0});
            const Vector3f v2 = params.GetOneVector3f("v2", {0, 1, 0});
            return PlanarMapping{textureFromRender, v1, v2, params.GetOneFloat("udelta", 0),
                                 params.GetOneFloat("vdelta", 0)};
        }
        default: {
            const float uScale = params.GetOneFloat("uscale", 1);
            const float vScale = params.GetOneFloat("vscale", 1);
            return UVMapping{uScale, vScale, params.GetOneFloat("udelta", 0),
                             params.GetOneFloat("vdelta", 0)};
        }
    }
}

}  // namespace pbrt
