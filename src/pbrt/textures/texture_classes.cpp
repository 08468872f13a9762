#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

#include "pbrt/textures/checkerboard.h"
#include "pbrt/textures/constant.h"
#include "pbrt/textures/imagemap.h"
#include "pbrt/textures/mix.h"
#include "pbrt/textures/per_face.h"
#include "pbrt/textures/scale.h"

namespace pbrt {
namespace {

template <typename T>
constexpr TextureClass ClassOf() {
    return {T::kName, T::CreateFloat, T::CreateSpectrum};
}

/// The one list of texture classes.
constexpr std::array kClasses{ClassOf<CheckerboardTexture>(), ClassOf<ConstantTexture>(),
                              ClassOf<ImageTexture>(),        ClassOf<MixTexture>(),
                              ClassOf<PerFaceTexture>(),      ClassOf<ScaleTexture>()};

constexpr auto kNames = [] {
    std::array<std::string_view, kClasses.size()> names;
    for (size_t i = 0; i < names.size(); ++i)
        names[i] = kClasses[i].name;
    return names;
}();

const TextureClass *FindClass(const TextureEntity &entity, Diagnostics &log) {
    for (const TextureClass &c : kClasses)
        if (c.name == entity.type) return &c;
    log.Error(entity.loc, UnknownName("texture class", entity.type, kNames));
    return nullptr;
}

void AddSpectra(NamedTextures &named, const std::string &name, const SpectrumByRole &byRole) {
    const auto add = [&](std::map<std::string, SpectrumTexture> &map, SpectrumType role) {
        if (const auto &texture = byRole[size_t(role)]) map.emplace(name, *texture);
    };
    add(named.albedos, SpectrumType::Albedo);
    add(named.unboundeds, SpectrumType::Unbounded);
    add(named.illuminants, SpectrumType::Illuminant);
}

/// Counts the textures that each texture is made of, again wherever it is used again: so many are
/// looked up where it is, and no more of them within each other.
class TextureCosts {
  public:
    /// False, with an error, where the texture is made of too many.
    bool Add(const TextureEntity &entity, Diagnostics &log) {
        constexpr uint64_t kMost = 1000;
        uint64_t cost = 1;
        for (const ParsedParameter &p : entity.params) {
            if (p.type != "texture") continue;
            for (const std::string &name : p.strings)
                if (const auto found = costs.find(name); found != costs.end())
                    cost += found->second;
        }
        const bool isFit = cost <= kMost;
        if (!isFit)
            log.Error(entity.loc, fmt::format("texture \"{}\" is made of more than {} others",
                                              Shortened(entity.name), kMost));
        uint64_t &known = costs[entity.name];  // of a float or a spectrum texture, or both
        known = std::max(known, isFit ? cost : 1);
        return isFit;
    }

  private:
    std::map<std::string, uint64_t> costs;
};

}  // namespace

std::span<const std::string_view> TextureClassNames() {
    return kNames;
}

std::span<const TextureClass> TextureClasses() {
    return kClasses;
}

NamedTextures BuildTextures(const SceneDescription &scene, const Transform &renderFromWorld,
                            Diagnostics &log) {
    NamedTextures named;
    TextureCosts costs;
    for (const TextureEntity &entity : scene.textures) {
        ParamDict params(entity.params, entity.loc, fmt::format("texture \"{}\"", entity.type),
                         entity.colorSpace, &log, scene.dir);
        const Transform textureFromRender = (renderFromWorld * entity.worldFromTexture).Inverse();
        TextureBuilder builder{params, named, textureFromRender};
        const TextureClass *textureClass =
            costs.Add(entity, log) ? FindClass(entity, log) : nullptr;
        // An unknown class stands as a constant, so that its uses are no further errors.
        if (entity.isFloat) {
            named.floats.emplace(entity.name,
                                 textureClass ? textureClass->createFloat(builder) : 1.f);
        } else {
            SpectrumByRole byRole;
            byRole.fill(SpectrumTexture(Spectrum(1.f)));
            if (textureClass) byRole = textureClass->createSpectrum(builder);
            AddSpectra(named, entity.name, byRole);
        }
        if (builder.readsUV || named.AnyReadsUV(entity.params)) named.readUV.insert(entity.name);
        if (textureClass) params.ReportUnused();
    }
    return named;
}

}  // namespace pbrt
