#pragma once

#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "pbrt/scene/description.h"

namespace pbrt {

/// Targets that `Attribute "target"` may name.
enum class AttributeTarget { Shape, Light, Material, Medium, Texture };
inline constexpr std::array<std::string_view, 5> kAttributeTargets{"shape", "light", "material",
                                                                   "medium", "texture"};

/// Gives the directives their meaning: keeps the graphics state and fills a SceneDescription.
/// Mistakes in the order and names of directives are reported to the diagnostics.
class SceneBuilder {
  public:
    SceneBuilder(SceneDescription *scene, Diagnostics *log);

    bool InWorld() const { return inWorld; }
    const RGBColorSpace *ColorSpace() const { return state.colorSpace; }
    void SetColorSpace(const RGBColorSpace *space) { state.colorSpace = space; }
    void Camera(Entity camera);
    void WorldBegin();
    void AddAttribute(AttributeTarget target, ParsedParameters parameters);
    void ReverseOrientation() { state.reverseOrientation = !state.reverseOrientation; }

    // The current transformation, at the shutter's start, end or both, as is active.
    void Concatenate(const Transform &t);
    void Replace(const Transform &t);
    /// The current transformation gets a part that has no inverse: shapes and objects that it
    /// places are flat and left out, until it is replaced.
    void Flatten();
    void ActivateTransforms(bool start, bool end) { state.active = {start, end}; }
    void SaveCoordinateSystem(const std::string &name) {
        coordinateSystems[name] = {state.ctm, state.flat};
    }
    /// False where there is none of this name.
    bool RestoreCoordinateSystem(const std::string &name);
    std::vector<std::string_view> CoordinateSystemNames() const;

    void AttributeBegin(const FileLoc &loc) { Push(false, loc); }
    void AttributeEnd(const FileLoc &loc) { Pop(false, loc); }
    void ObjectBegin(const std::string &name, const FileLoc &loc);
    void ObjectEnd(const FileLoc &loc);
    void ObjectInstance(const std::string &name, const FileLoc &loc);

    void Shape(Entity shape);
    void LightSource(Entity light);
    void AreaLightSource(Entity light);
    void Material(Entity material);
    void MakeNamedMaterial(const std::string &name, Entity material);
    /// Takes note of the name of a material whose definition was refused.
    void RefuseNamedMaterial(const std::string &name, const FileLoc &loc) {
        namedMaterials.try_emplace(name, loc);
    }
    void NamedMaterial(const std::string &name, const FileLoc &loc);
    /// Media are refused where they are made; a use is an error where there is none of its name.
    void DefineMedium(const std::string &name, const FileLoc &loc) { media.try_emplace(name, loc); }
    void UseMedium(const std::string &name, const FileLoc &loc) {
        mediumUses.try_emplace(name, loc);
    }
    void Texture(const std::string &name, bool isFloat, Entity texture);

    /// Between the two, a file is read whose changes of state and coordinate systems stay inside.
    void BeginImport();
    void EndImport();
    /// After the last file: what is left open, undefined or contains itself is reported. Uses of
    /// undefined objects and uses that close a circle are left out.
    void Finish();

  private:
    /// By time, whether the transformation has no inverse (and its matrix is another one).
    using Flat = std::array<bool, 2>;
    struct CoordinateSystem {
        TransformPair transforms;
        Flat flat{};
    };
    struct State {
        TransformPair ctm;
        Flat flat{};
        std::array<bool, 2> active{true, true};
        bool reverseOrientation = false;
        const RGBColorSpace *colorSpace = &RGBColorSpace::sRGB();
        int material = -1;
        std::string namedMaterial;
        FileLoc namedMaterialLoc;
        std::shared_ptr<const Entity> areaLight;
        std::array<ParsedParameters, kAttributeTargets.size()> attributes;
    };
    /// AttributeBegin or ObjectBegin, and the state to return to.
    struct Scope {
        State state;
        FileLoc loc;
        bool isObject;
    };
    struct Import {
        State state;
        std::vector<Scope> scopes;
        std::map<std::string, CoordinateSystem> coordinateSystems;
        ObjectEntity *object;
    };
    using Definitions = std::unordered_map<std::string, FileLoc>;

    void Push(bool isObject, const FileLoc &loc);
    bool Pop(bool isObject, const FileLoc &loc);
    void ReportUnclosed();
    /// Appends what Attribute directives add to the entities of this kind.
    void Inherit(AttributeTarget target, Entity *entity) const;
    /// Notes a definition; an error and false where the name is taken.
    bool Define(Definitions *places, std::string_view kind, const std::string &name,
                const FileLoc &loc);
    /// Warns that the transform at the shutter's start stands for a moving one.
    void WarnIfMoving(std::string_view what, const FileLoc &loc);
    bool IsFlat() const { return state.flat[0] || state.flat[1]; }
    bool IsMoving() const { return state.ctm[0] != state.ctm[1]; }
    /// "" and "none" become "interface", with a warning.
    void UseNewName(Entity *material) const;
    void CheckMaterialUses();
    void CheckMediumUses();
    void CheckInstanceUses();

    SceneDescription *scene;
    Diagnostics *log;
    State state;
    std::vector<Scope> scopes;
    std::vector<Import> imports;
    std::map<std::string, CoordinateSystem> coordinateSystems;
    bool inWorld = false;
    ObjectEntity *object = nullptr;  ///< being defined
    std::string objectName;
    ObjectEntity redefined;  ///< takes what a refused definition holds
    Definitions floatTextures, spectrumTextures, namedMaterials, media;
    Definitions mediumUses;                                     ///< the first of each name
    std::vector<std::pair<std::string, FileLoc>> materialUses;  ///< by shapes
};

}  // namespace pbrt
