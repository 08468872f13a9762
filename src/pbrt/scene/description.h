#pragma once

#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/scene/packed_entities.h"
#include "pbrt/scene/scene_content.h"

namespace pbrt {

struct LightEntity : Entity {
    Transform worldFromLight;
};

struct TextureEntity : Entity {
    std::string name;
    bool isFloat = true;
    Transform worldFromTexture;
};

struct NamedMaterialEntity : Entity {
    std::string name;
};

/// ObjectBegin ... ObjectEnd: shapes in world coordinates of the definition, and nested uses.
struct ObjectEntity {
    FileLoc loc;
    PackedEntities<ShapeEntity> shapes;
    PackedEntities<InstanceUse> instances;
};

/// Values that `Option` and the command line set; the file's win (PBRT_FORMAT 1.3).
struct Options {
    int seed = 0;
    bool disablePixelJitter = false;
    bool disableWavelengthJitter = false;
    bool disableTextureFiltering = false;
    bool forceDiffuse = false;
    bool pixelStats = false;
    std::string renderCoordSys = "cameraworld";
    std::string mseReferenceImage, mseReferenceOut;
    /// Puts numbers into scene text where it says $frame (scene/frame_text.h).
    std::optional<int> frame;
};

/// Names that `Option` takes, as PBRT_FORMAT 1.4 spells them.
std::span<const std::string_view> OptionNames();
/// Rows that document the options, but for those that have no effect here.
std::span<const ParamRow> OptionRows();

/// A whole scene as written: plain entities, printable, nothing interpreted.
struct SceneDescription {
    Entity film, camera, sampler, filter, integrator, accelerator;
    TransformPair cameraFromWorld;
    float transformStart = 0, transformEnd = 1;
    PackedEntities<Entity> materials;  ///< those without names
    std::vector<NamedMaterialEntity> namedMaterials;
    std::vector<TextureEntity> textures;  ///< in file order
    std::vector<LightEntity> lights;
    PackedEntities<ShapeEntity> shapes;
    std::map<std::string, ObjectEntity> objects;
    PackedEntities<InstanceUse> instances;
    Options options;
    std::string dir;                    ///< folder of the last top-level scene file
    std::deque<std::string> fileNames;  ///< names that FileLoc::file points into
    SceneContent content;               ///< of all files read
};

/// Reads scene files (or standard input for an empty list or "-") into `scene`. Mistakes go to the
/// diagnostics; parsing goes on after each where it can. `scene.options` holds the command line's
/// values on entry. Named materials that shapes refer to and that are not defined are reported.
/// Every object that is used is defined, and none contains itself: what would is reported and left
/// out.
void ParseFiles(const std::vector<std::string> &files, SceneDescription &scene, Diagnostics &log);
/// True after the parsing of a scene for pbrt-v3 or older, which has been reported: it names
/// several things as these did. There is no use in building it.
bool IsOld(const Diagnostics &log);
/// The same from text; `name` stands for the file in messages, `dir` for its folder.
void ParseString(std::string_view text, std::string_view name, std::string_view dir,
                 SceneDescription &scene, Diagnostics &log);

}  // namespace pbrt
