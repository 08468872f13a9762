#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "pbrt/scene/arguments.h"
#include "pbrt/scene/builder.h"
#include "pbrt/util/upstream.h"

namespace pbrt {

/// State that the directives of a scene share: where arguments come from and where they go.
struct DirectiveContext {
    /// Reads the file that a directive at `use` names, in place.
    using ReadNested = std::function<void(const std::string &name, const FileLoc &use)>;

    DirectiveContext(SceneDescription *scene, IsDirectiveName isDirective, Diagnostics *log,
                     ReadNested readNested)
        : scene(scene),
          log(log),
          builder(scene, log),
          arguments(isDirective, log),
          readNested(std::move(readNested)) {}

    /// A plug-in of this kind ("film"); `what` is what its name is in messages ("the film's name").
    std::optional<Entity> NamedEntity(std::string_view kind, std::string_view what) {
        std::optional<Entity> entity = arguments.NamedEntity(what, builder.ColorSpace());
        if (entity) NoteIfOld(kind, entity->type, entity->loc);
        return entity;
    }
    void NoteIfOld(std::string_view kind, std::string_view name, const FileLoc &loc) {
        if (const OldName *const old = FindOldName(kind, name)) log->NoteOldName(*old, loc);
    }

    SceneDescription *scene;
    Diagnostics *log;
    SceneBuilder builder;
    Arguments arguments;
    ReadNested readNested;
    FileLoc worldBegin;  ///< line 0 before it
    bool saidTransformBegin = false;
};

}  // namespace pbrt
