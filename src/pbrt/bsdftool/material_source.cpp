#include "pbrt/bsdftool/material_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>

#include "pbrt/materials/mix.h"
#include "pbrt/scene/parser.h"
#include "pbrt/textures/texture.h"

namespace pbrt::bsdftool {
namespace {

struct Candidate {
    Entity entity;
    std::string name;  ///< empty for those of `Material`
};

/// The scene's materials in the order of their lines (of one file; each file's by themselves).
std::vector<Candidate> MaterialsOf(const SceneDescription &scene) {
    std::vector<Candidate> all;
    for (const NamedMaterialEntity &e : scene.namedMaterials)
        all.push_back({e, e.name});
    for (const Entity &e : scene.materials)
        all.push_back({e, {}});
    const auto file = [&](const Candidate &c) {
        return std::find(scene.fileNames.begin(), scene.fileNames.end(), c.entity.loc.file) -
               scene.fileNames.begin();
    };
    std::stable_sort(all.begin(), all.end(), [&](const Candidate &a, const Candidate &b) {
        const FileLoc &la = a.entity.loc, &lb = b.entity.loc;
        return std::tuple(file(a), la.line, la.column) < std::tuple(file(b), lb.line, lb.column);
    });
    return all;
}

/// Text has blanks or quotes, or it could be no directive; everything else is meant as a file.
bool IsFileName(const std::string &source) {
    std::error_code noName;  // text may be longer than any name
    return std::filesystem::is_regular_file(source, noName) ||
           source.find_first_of(" \t\n\"") == std::string::npos;
}

void ReadScene(const std::string &source, SceneDescription &scene, Diagnostics &log) {
    if (IsFileName(source)) {
        ParseFiles({source}, scene, log);
        return;
    }
    Parser parser(&scene, &log);
    parser.ReadText("WorldBegin", "<world>", ".");  // by itself, so that columns are the user's
    parser.ReadText(source, "<material>", ".");
    parser.Finish();
}

std::optional<Candidate> Choose(const std::vector<Candidate> &all, const std::string &source,
                                const std::string &pick, Diagnostics &log) {
    if (all.empty()) {
        log.Error({}, fmt::format("no material in \"{}\": give a directive such as 'Material "
                                  "\"featherbarbule\"', or a scene file",
                                  Shortened(source)));
        return {};
    }
    if (pick.empty()) return all.front();
    std::vector<std::string_view> known;
    for (const Candidate &c : all) {
        if (c.name == pick || c.entity.type == pick) return c;
        known.push_back(c.name.empty() ? c.entity.type : c.name);
    }
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    log.Error({}, UnknownName("material", pick, known));
    return {};
}

}  // namespace

std::optional<MaterialSource> ReadMaterial(const std::string &source, const std::string &pick,
                                           Diagnostics &log) {
    const int before = log.ErrorCount();
    SceneDescription scene;
    ReadScene(source, scene, log);
    if (log.ErrorCount() > before) return {};
    const auto chosen = Choose(MaterialsOf(scene), source, pick, log);
    if (!chosen) return {};
    const Entity &entity = chosen->entity;
    if (entity.type == InterfaceMaterial::kName) {
        log.Error(entity.loc, "an interface scatters nothing");
        return {};
    }
    if (entity.type == MixMaterial::kName) {
        log.Error(entity.loc, "a mix scatters as the materials it is made of: ask for one of them");
        return {};
    }
    const NamedTextures textures = BuildTextures(scene, Transform(), log);
    ParamDict params(entity.params, entity.loc, fmt::format("material \"{}\"", entity.type),
                     entity.colorSpace, &log, scene.dir);
    std::optional<Material> material = CreateMaterial(entity.type, params, textures);
    if (!material || log.ErrorCount() > before) return {};
    return MaterialSource{entity.type, std::move(*material)};
}

}  // namespace pbrt::bsdftool
