#include <fmt/format.h>

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

}  // namespace

std::span<const std::string_view> TextureClassNames() {
    return kNames;
}

NamedTextures BuildTextures(const Description &scene, const Transform &renderFromWorld,
                            Diagnostics &log) {
    NamedTextures named;
    for (const TextureEntity &entity : scene.textures) {
        ParamDict params(entity.params, entity.loc, fmt::format("texture \"{}\"", entity.type),
                         entity.colorSpace, &log, scene.dir);
        const Transform textureFromRender = (renderFromWorld * entity.worldFromTexture).Inverse();
        TextureBuilder builder{params, named, textureFromRender};
        const TextureClass *textureClass = FindClass(entity, log);
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
