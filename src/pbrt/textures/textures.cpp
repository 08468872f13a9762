#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/textures/textures.h"

namespace pbrt {
namespace {

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

std::vector<std::string_view> SpectrumTextureNames() {
    std::vector<std::string_view> names;
    TextureTypes::ForEach([&]<typename T>() {
        if constexpr (SpectrumTextureType<T>) names.push_back(T::kName);
    });
    return names;
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
        // A wrong class stands as a constant, so that its uses are no further errors.
        FloatTexture number = 1.f;
        SpectrumByRole spectra;
        spectra.fill(SpectrumTexture(Spectrum(1.f)));
        const auto create = [&]<typename T>() {
            if (entity.isFloat)
                number = T::CreateFloat(builder);
            else if constexpr (SpectrumTextureType<T>)
                spectra = T::CreateSpectrum(builder);
            else
                return params.Error(fmt::format(
                    "texture class \"{0}\" makes floats only; make it a float texture and use that "
                    "as \"texture scale\" of a spectrum texture of class \"scale\"",
                    T::kName));
            params.ReportUnused();
        };
        if (costs.Add(entity, log) && !TextureTypes::Visit(entity.type, create))
            log.Error(entity.loc, UnknownName("texture class", entity.type, TextureTypes::kNames));
        if (entity.isFloat)
            named.floats.emplace(entity.name, number);
        else
            AddSpectra(named, entity.name, spectra);
        if (builder.readsUV || named.AnyReadsUV(entity.params)) named.readUV.insert(entity.name);
    }
    return named;
}

}  // namespace pbrt
