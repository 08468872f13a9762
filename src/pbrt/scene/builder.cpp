#include "pbrt/scene/builder.h"

#include <fmt/format.h>

namespace pbrt {

SceneBuilder::SceneBuilder(SceneDescription *scene, Diagnostics *log) : scene(scene), log(log) {}

void SceneBuilder::Camera(Entity camera) {
    if (IsFlat())
        log->Error(camera.loc, "the camera's transformation has no inverse: it sees nothing");
    scene->camera = std::move(camera);
    scene->cameraFromWorld = state.ctm;
    coordinateSystems["camera"] = {{state.ctm[0].Inverse(), state.ctm[1].Inverse()}};
}

void SceneBuilder::WorldBegin() {
    inWorld = true;
    state.ctm = {};
    state.flat = {};
    state.active = {true, true};
    SaveCoordinateSystem("world");
}

void SceneBuilder::AddAttribute(AttributeTarget target, ParsedParameters parameters) {
    for (ParsedParameter &p : parameters) {
        p.mayBeUnused = true;
        state.attributes[size_t(target)].push_back(std::move(p));
    }
}

void SceneBuilder::Inherit(AttributeTarget target, Entity *entity) const {
    const ParsedParameters &inherited = state.attributes[size_t(target)];
    entity->params.insert(entity->params.end(), inherited.begin(), inherited.end());
}

// --- Transformations ---

void SceneBuilder::Concatenate(const Transform &t) {
    for (int i = 0; i < 2; ++i)
        if (state.active[i]) state.ctm[i] = state.ctm[i] * t;
}

void SceneBuilder::Replace(const Transform &t) {
    for (int i = 0; i < 2; ++i)
        if (state.active[i]) state.ctm[i] = t, state.flat[i] = false;
}

void SceneBuilder::Flatten() {
    for (int i = 0; i < 2; ++i)
        state.flat[i] = state.flat[i] || state.active[i];
}

bool SceneBuilder::RestoreCoordinateSystem(const std::string &name) {
    const auto found = coordinateSystems.find(name);
    if (found == coordinateSystems.end()) return false;
    state.ctm = found->second.transforms;
    state.flat = found->second.flat;
    return true;
}

std::vector<std::string_view> SceneBuilder::CoordinateSystemNames() const {
    std::vector<std::string_view> names;
    for (const auto &[name, unused] : coordinateSystems)
        names.push_back(name);
    return names;
}

void SceneBuilder::WarnIfMoving(std::string_view what, const FileLoc &loc) {
    if (!IsMoving()) return;
    log->Warning(loc, fmt::format("{} cannot move: its transformation at the shutter's opening is "
                                  "used throughout",
                                  what));
}

// --- Scopes ---

void SceneBuilder::Push(bool isObject, const FileLoc &loc) {
    scopes.push_back({state, loc, isObject});
}

bool SceneBuilder::Pop(bool isObject, const FileLoc &loc) {
    const std::string_view kind = isObject ? "Object" : "Attribute";
    if (scopes.empty()) {
        log->Error(loc, fmt::format("{0}End without {0}Begin", kind));
        return false;
    }
    if (scopes.back().isObject != isObject) {
        const FileLoc &begin = scopes.back().loc;
        log->Error(loc, fmt::format("{}End inside {}Begin of {}:{}:{}, which is still open", kind,
                                    isObject ? "Attribute" : "Object", begin.file, begin.line,
                                    begin.column));
        return false;
    }
    state = std::move(scopes.back().state);
    scopes.pop_back();
    return true;
}

void SceneBuilder::ReportUnclosed() {
    for (const Scope &s : scopes)
        log->Error(s.loc,
                   fmt::format("{0}Begin without {0}End", s.isObject ? "Object" : "Attribute"));
}

void SceneBuilder::BeginImport() {
    imports.push_back({state, std::move(scopes), coordinateSystems, object});
    scopes.clear();
    std::erase_if(coordinateSystems, [](const auto &named) {
        return named.first != "camera" && named.first != "world";
    });
}

void SceneBuilder::EndImport() {
    ReportUnclosed();
    state = std::move(imports.back().state);
    scopes = std::move(imports.back().scopes);
    coordinateSystems = std::move(imports.back().coordinateSystems);
    object = imports.back().object;
    imports.pop_back();
}

void SceneBuilder::ObjectBegin(const std::string &name, const FileLoc &loc) {
    Push(true, loc);
    if (object) {
        log->Error(loc, fmt::format("ObjectBegin \"{}\" inside the definition of object \"{}\"",
                                    name, objectName));
        return;
    }
    const auto [entry, isNew] = scene->objects.try_emplace(name);
    if (!isNew) {
        const FileLoc &first = entry->second.loc;
        log->Error(loc, fmt::format("object \"{}\" is already defined at {}:{}:{}", name,
                                    first.file, first.line, first.column));
    }
    object = isNew ? &entry->second : &redefined;
    object->loc = loc;
    objectName = name;
}

void SceneBuilder::ObjectEnd(const FileLoc &loc) {
    if (!Pop(true, loc)) return;
    for (const Scope &s : scopes)
        if (s.isObject) return;  // the end of a refused inner definition
    object = nullptr;
}

void SceneBuilder::ObjectInstance(const std::string &name, const FileLoc &loc) {
    if (IsFlat()) return;
    (object ? object->instances : scene->instances).Append({name, loc, state.ctm});
}

// --- Entities ---

bool SceneBuilder::Define(Definitions *places, std::string_view kind, const std::string &name,
                          const FileLoc &loc) {
    const auto [entry, isNew] = places->try_emplace(name, loc);
    if (isNew) return true;
    const FileLoc &first = entry->second;
    log->Error(loc, fmt::format("{} \"{}\" is already defined at {}:{}:{}", kind, name, first.file,
                                first.line, first.column));
    return false;
}

void SceneBuilder::Shape(Entity shape) {
    if (IsFlat()) return;
    Inherit(AttributeTarget::Shape, &shape);
    ShapeEntity s;
    static_cast<Entity &>(s) = std::move(shape);
    s.worldFromObject = state.ctm;
    s.reverseOrientation = state.reverseOrientation;
    s.material = state.material;
    if (!state.namedMaterial.empty()) {
        s.namedMaterial = state.namedMaterial;
        if (materialUses.empty() || materialUses.back().second != state.namedMaterialLoc)
            materialUses.emplace_back(state.namedMaterial, state.namedMaterialLoc);
    }
    if (state.areaLight && object)
        log->Warning(s.loc,
                     "area lights are not instanced: this shape of an object does not shine");
    else
        s.areaLight = state.areaLight;
    (object ? object->shapes : scene->shapes).Append(s);
}

void SceneBuilder::LightSource(Entity light) {
    if (IsFlat()) return;
    WarnIfMoving("a light", light.loc);
    Inherit(AttributeTarget::Light, &light);
    LightEntity &l = scene->lights.emplace_back();
    static_cast<Entity &>(l) = std::move(light);
    l.worldFromLight = state.ctm[0];
}

void SceneBuilder::AreaLightSource(Entity light) {
    Inherit(AttributeTarget::Light, &light);
    state.areaLight = std::make_shared<const Entity>(std::move(light));
}

void SceneBuilder::UseNewName(Entity *material) const {
    if (!material->type.empty() && material->type != "none") return;
    log->Warning(material->loc,
                 fmt::format("material \"{}\" is an older name of \"interface\"", material->type));
    material->type = "interface";
}

void SceneBuilder::Material(Entity material) {
    UseNewName(&material);
    Inherit(AttributeTarget::Material, &material);
    state.material = int(scene->materials.size());
    state.namedMaterial.clear();
    scene->materials.Append(material);
}

void SceneBuilder::MakeNamedMaterial(const std::string &name, Entity material) {
    if (!Define(&namedMaterials, "material", name, material.loc)) return;
    UseNewName(&material);
    Inherit(AttributeTarget::Material, &material);
    NamedMaterialEntity &m = scene->namedMaterials.emplace_back();
    static_cast<Entity &>(m) = std::move(material);
    m.name = name;
}

void SceneBuilder::NamedMaterial(const std::string &name, const FileLoc &loc) {
    state.namedMaterial = name;
    state.namedMaterialLoc = loc;
    state.material = -1;
}

void SceneBuilder::Texture(const std::string &name, bool isFloat, Entity texture) {
    if (!Define(isFloat ? &floatTextures : &spectrumTextures,
                isFloat ? "float texture" : "spectrum texture", name, texture.loc))
        return;
    WarnIfMoving("a texture", texture.loc);
    Inherit(AttributeTarget::Texture, &texture);
    TextureEntity &t = scene->textures.emplace_back();
    static_cast<Entity &>(t) = std::move(texture);
    t.name = name;
    t.isFloat = isFloat;
    t.worldFromTexture = state.ctm[0];
}

}  // namespace pbrt
