#pragma once

#include <variant>

#include "pbrt/textures/texture.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// Texture coordinates (s, t) and what they change per pixel step.
struct TexCoord2D {
    Point2f st;
    float dsdx = 0, dsdy = 0, dtdx = 0, dtdy = 0;
};

/// (s, t) = (uscale u + udelta, vscale v + vdelta).
struct UVMapping {
    float uScale = 1, vScale = 1, uDelta = 0, vDelta = 0;
    TexCoord2D Map(const TextureEvalContext &ctx) const {
        return {{uScale * ctx.uv.x + uDelta, vScale * ctx.uv.y + vDelta},
                uScale * ctx.dudx,
                uScale * ctx.dudy,
                vScale * ctx.dvdx,
                vScale * ctx.dvdy};
    }
};

/// s = theta / pi from the +z axis, t = phi / (2 pi) in [0, 1), of the point in texture space.
struct SphericalMapping {
    Transform textureFromRender;
    TexCoord2D Map(const TextureEvalContext &ctx) const;
};

/// s = (pi + phi) / (2 pi), t = z of the point in texture space.
struct CylindricalMapping {
    Transform textureFromRender;
    TexCoord2D Map(const TextureEvalContext &ctx) const;
};

/// s = p . v1 + udelta, t = p . v2 + vdelta of the point in texture space.
struct PlanarMapping {
    Transform textureFromRender;
    Vector3f v1{1, 0, 0}, v2{0, 1, 0};
    float uDelta = 0, vDelta = 0;
    TexCoord2D Map(const TextureEvalContext &ctx) const;
};

class TextureMapping2D {
  public:
    TextureMapping2D() = default;
    template <typename Mapping>
    TextureMapping2D(Mapping mapping) : mapping(std::move(mapping)) {}
    /// Reads `mapping` and its parameters.
    static TextureMapping2D Create(ParamDict &params, const Transform &textureFromRender);

    TexCoord2D Map(const TextureEvalContext &ctx) const {
        if (const auto *uv = std::get_if<UVMapping>(&mapping)) return uv->Map(ctx);
        return std::visit([&](const auto &m) { return m.Map(ctx); }, mapping);
    }

    /// A property of the surface, not of the point alone.
    bool ReadsUV() const { return std::holds_alternative<UVMapping>(mapping); }

  private:
    std::variant<UVMapping, SphericalMapping, CylindricalMapping, PlanarMapping> mapping;
};

}  // namespace pbrt
