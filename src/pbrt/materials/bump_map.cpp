#include "pbrt/materials/bump_map.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/image/image.h"
#include "pbrt/textures/mipmap.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

constexpr FloatParam kDisplacement{
    "displacement", "", 0, -kOpen, kOpen, "height of a relief that shading shows: a float texture"};
constexpr StringParam kNormalMap{
    "normalmap", "", "image of shading normals, linear: x, y, z in R, G, B as (1 + n) / 2"};

/// Null after an error.
std::shared_ptr<const MIPMap> ReadNormals(ParamDict &params, const std::string &file) {
    constexpr ColorEncoding kLinear{ColorEncoding::Kind::Linear, 1};
    const OrError<Image> read = ReadImage(file, kLinear);
    if (!read) {
        params.Error(kNormalMap.name, read.error);
        return nullptr;
    }
    if (const auto why = WhyTooLarge(MIPMap::BytesToCreate(*read.value))) {
        params.Error(kNormalMap.name, fmt::format("\"{}\" as a normal map {}", file, *why));
        return nullptr;
    }
    std::shared_ptr<const MIPMap> map = MIPMap::Create(*read.value, kLinear);
    if (map && map->NChannels() == 3) return map;
    params.Error(
        kNormalMap.name,
        fmt::format("\"{}\" has no channels R, G and B, which a normal map needs; it has {}", file,
                    fmt::join(read.value->ChannelNames(), ", ")));
    return nullptr;
}

/// n, of any length but finite and not 0, as a shading normal.
void SetShadingNormal(Vector3f n, SurfaceInteraction *sp) {
    const float length = Length(n);
    if (!(length > 0 && length < Infinity)) return;
    const Vector3f unit = n / length;
    sp->ns = Dot(unit, sp->n) < 0 ? -unit : unit;
}

}  // namespace

std::shared_ptr<const BumpMap> BumpMap::Create(ParamDict &params, const NamedTextures &named) {
    BumpMap bump;
    bump.height = GetFloatTexture(params, named, kDisplacement);
    if (const std::string file = params.GetFileName(kNormalMap); !file.empty())
        bump.normals = ReadNormals(params, file);
    if (!bump.normals && bump.height.IsConstant()) return nullptr;
    return std::make_shared<const BumpMap>(bump);
}

void BumpMap::Ignore(ParamDict &params) {
    params.GetFileName(kNormalMap);
}

void BumpMap::Tilt(const TextureEvalContext &ctx, SurfaceInteraction *sp) const {
    if (normals)
        SetShadingNormal(FromNormalMap(ctx, *sp), sp);
    else
        TiltByHeight(ctx, sp);
}

Vector3f BumpMap::FromNormalMap(const TextureEvalContext &ctx, const SurfaceInteraction &sp) const {
    // Rows of images run downwards.
    const RGB rgb = normals->Lookup<RGB>({ctx.uv.x, 1 - ctx.uv.y}, {}, {});
    const Vector3f local{2 * rgb.r - 1, 2 * rgb.g - 1, 2 * rgb.b - 1};
    return sp.ShadingFrame().FromLocal(local);
}

/// The surface p + h ns has the tangents dpdu + dh/du ns and dpdv + dh/dv ns, but for h times the
/// change of ns: Blinn 1978, "Simulation of Wrinkled Surfaces". pbrt-v4 keeps that term, which
/// matters where h is no longer small against the radius of curvature; then shading alone cannot
/// show the relief anyway.
void BumpMap::TiltByHeight(const TextureEvalContext &ctx, SurfaceInteraction *sp) const {
    // Half a pixel, so that filtered textures are not asked for more than they have; without
    // derivatives a small step.
    constexpr float kLeastStep = 0.0005f;
    const auto step = [](float a, float b) {
        const float d = 0.5f * (std::abs(a) + std::abs(b));
        return d > 0 ? d : kLeastStep;
    };
    const float du = step(ctx.dudx, ctx.dudy), dv = step(ctx.dvdx, ctx.dvdy);
    const auto heightAt = [&](Vector3f offset, float u, float v) {
        TextureEvalContext moved = ctx;
        moved.p = ctx.p + offset;
        moved.uv = {ctx.uv.x + u, ctx.uv.y + v};
        return height.Evaluate(moved);
    };
    const Vector3f ns = sp->ns;
    const auto inPlane = [&](Vector3f v) { return v - Dot(v, ns) * ns; };
    const Vector3f tu = inPlane(sp->dpdu), tv = inPlane(sp->dpdv);
    const float h = height.Evaluate(ctx);
    const float slopeU = (heightAt(du * tu, du, 0) - h) / du;
    const float slopeV = (heightAt(dv * tv, 0, dv) - h) / dv;
    SetShadingNormal(Cross(tu + slopeU * ns, tv + slopeV * ns), sp);
    // The shading tangent rises with the relief, too.
    const float a = Dot(tu, tu), b = Dot(tu, tv), c = Dot(tv, tv), det = a * c - b * b;
    if (!(det > 0)) return;
    const float x = Dot(tu, sp->dpdus), y = Dot(tv, sp->dpdus);
    const float rise = ((c * x - b * y) * slopeU + (a * y - b * x) * slopeV) / det;
    if (std::isfinite(rise)) sp->dpdus = inPlane(sp->dpdus) + rise * ns;
}

}  // namespace pbrt
