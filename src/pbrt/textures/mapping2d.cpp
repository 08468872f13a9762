#include "pbrt/textures/mapping2d.h"

#include <array>

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 4> kNames{"uv", "spherical", "cylindrical", "planar"};
constexpr ChoiceParam kMapping{"mapping", kNames[0], kNames, "how points get coordinates (s, t)"};
constexpr FloatParam kUScale{"uscale", "", 1, -kOpen, kOpen, "factor of u, mapping uv"};
constexpr FloatParam kVScale{"vscale", "", 1, -kOpen, kOpen, "factor of v, mapping uv"};
constexpr FloatParam kUDelta{"udelta", "", 0, -kOpen, kOpen, "added to s, mappings uv and planar"};
constexpr FloatParam kVDelta{"vdelta", "", 0, -kOpen, kOpen, "added to t, mappings uv and planar"};
constexpr PointParam kV1{"v1", "vector3", {1, 0, 0}, "s is p . v1, mapping planar"};
constexpr PointParam kV2{"v2", "vector3", {0, 1, 0}, "t is p . v2, mapping planar"};

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
    switch (params.GetOneChoice(kMapping)) {
        case 1:
            return SphericalMapping{textureFromRender};
        case 2:
            return CylindricalMapping{textureFromRender};
        case 3: {
            const Vector3f v1 = params.GetOneVector3f(kV1);
            const Vector3f v2 = params.GetOneVector3f(kV2);
            return PlanarMapping{textureFromRender, v1, v2, params.GetOneFloat(kUDelta),
                                 params.GetOneFloat(kVDelta)};
        }
        default: {
            const float uScale = params.GetOneFloat(kUScale);
            const float vScale = params.GetOneFloat(kVScale);
            return UVMapping{uScale, vScale, params.GetOneFloat(kUDelta),
                             params.GetOneFloat(kVDelta)};
        }
    }
}

}  // namespace pbrt
