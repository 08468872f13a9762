#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "pbrt/scene/description.h"
#include "pbrt/scene/params.h"
#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/vecmath.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// Steps of a surface point and of its uv per pixel; 0 where no filtering is wanted.
template <typename T>
struct TextureFootprint {
    Vec3<T> dpdx, dpdy;
    T dudx{}, dudy{}, dvdx{}, dvdy{};
};
inline TextureFootprint<float> Lane(const TextureFootprint<FloatX16> &f, int i) {
    return {Lane(f.dpdx, i), Lane(f.dpdy, i), f.dudx[i], f.dudy[i], f.dvdx[i], f.dvdy[i]};
}

/// Where a texture is looked up. `p` in rendering space.
struct TextureEvalContext : TextureFootprint<float> {
    Point3f p;
    Normal3f n;
    Point2f uv;
    int faceIndex = 0;  ///< the mesh's face index, else the number of the primitive
};

/// A texture that is more than a constant; immutable.
class FloatNode {
  public:
    virtual ~FloatNode() = default;
    virtual float Evaluate(const TextureEvalContext &ctx) const = 0;
};
class SpectrumNode {
  public:
    virtual ~SpectrumNode() = default;
    virtual SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                                     const SampledWavelengths &lambda) const = 0;
};

/// A constant, or a node. Constants cost no call.
class FloatTexture {
  public:
    FloatTexture() = default;
    FloatTexture(float value) : value(value) {}
    FloatTexture(std::shared_ptr<const FloatNode> node) : node(std::move(node)) {}
    bool IsConstant() const { return !node; }
    /// Only where IsConstant().
    float Constant() const { return value; }
    float Evaluate(const TextureEvalContext &ctx) const {
        return node ? node->Evaluate(ctx) : value;
    }

  private:
    float value = 0;
    std::shared_ptr<const FloatNode> node;
};

class SpectrumTexture {
  public:
    SpectrumTexture() = default;
    SpectrumTexture(Spectrum value) : value(std::move(value)) {}
    SpectrumTexture(std::shared_ptr<const SpectrumNode> node) : node(std::move(node)) {}
    bool IsConstant() const { return !node; }
    const Spectrum &Constant() const { return value; }
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const {
        return node ? node->Evaluate(ctx, lambda) : value.Sample(lambda);
    }

  private:
    Spectrum value;
    std::shared_ptr<const SpectrumNode> node;
};

/// An image texture's pixels; shared between textures that name the same file. In mipmap.h.
class MIPMap;
/// The same of Ptex files. In pbrt/ptex/texture.h.
class PtexTexture;

/// The named textures of a scene. A spectrum texture exists once per role, because its RGB values
/// become spectra by role.
struct NamedTextures {
    std::map<std::string, FloatTexture> floats;
    std::map<std::string, SpectrumTexture> albedos, unboundeds, illuminants;
    std::map<std::string, std::shared_ptr<const MIPMap>> images;  ///< by file name and decoding
    std::map<std::string, std::shared_ptr<const PtexTexture>> faceFiles;  ///< by file name
    std::set<std::string> readUV;  ///< names of those that look at the surface's uv
    bool readFootprints = false;   ///< some texture reads the steps per pixel of its context

    /// True if a parameter names a texture that looks at the surface's uv.
    bool AnyReadsUV(const ParsedParameters &params) const;
    const std::map<std::string, SpectrumTexture> &Spectra(SpectrumType role) const {
        return role == SpectrumType::Albedo      ? albedos
               : role == SpectrumType::Unbounded ? unboundeds
                                                 : illuminants;
    }
};

/// Builds every texture of the scene in file order (a texture may use earlier ones only).
/// `renderFromWorld` maps texture space into the space of TextureEvalContext::p.
NamedTextures BuildTextures(const SceneDescription &scene, const Transform &renderFromWorld,
                            Diagnostics &log);
std::span<const std::string_view> TextureClassNames();

/// `"texture name"`, or `"float name"`, else the default. A constant outside [row.lo, row.hi] is an
/// error; looked-up values are not checked here.
FloatTexture GetFloatTexture(ParamDict &params, const NamedTextures &named, const FloatParam &row);
/// Without range and with a plain default.
FloatTexture GetFloatTexture(ParamDict &params, const NamedTextures &named, std::string_view name,
                             float def);
/// nullopt where the parameter was not given as float or texture.
std::optional<FloatTexture> FindFloatTexture(ParamDict &params, const NamedTextures &named,
                                             std::string_view name);
/// `"texture name"`, or rgb, spectrum, blackbody; nullopt where not given.
std::optional<SpectrumTexture> FindSpectrumTexture(ParamDict &params, const NamedTextures &named,
                                                   std::string_view name, SpectrumType role);
inline SpectrumTexture GetSpectrumTexture(ParamDict &params, const NamedTextures &named,
                                          std::string_view name, const Spectrum &def,
                                          SpectrumType role) {
    return FindSpectrumTexture(params, named, name, role).value_or(SpectrumTexture(def));
}

}  // namespace pbrt
