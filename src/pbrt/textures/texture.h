#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "pbrt/base/texture.h"
#include "pbrt/scene/description.h"
#include "pbrt/scene/params.h"

namespace pbrt {

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

/// `"texture name"`, or `"float name"`, else the default. A constant outside [row.lo, row.hi] is an
/// error; looked-up values are not checked here.
FloatTexture GetFloatTexture(ParamDict &params, const NamedTextures &named, const FloatParam &row);
/// `"texture name"`, or rgb, spectrum, blackbody; nullopt where not given.
std::optional<SpectrumTexture> FindSpectrumTexture(ParamDict &params, const NamedTextures &named,
                                                   const SpectrumParam &row);
/// The same; the row's default where not given.
SpectrumTexture GetSpectrumTexture(ParamDict &params, const NamedTextures &named,
                                   const SpectrumParam &row);

}  // namespace pbrt
