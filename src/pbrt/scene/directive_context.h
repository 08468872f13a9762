#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "pbrt/scene/arguments.h"
#include "pbrt/scene/builder.h"

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

    std::optional<Entity> NamedEntity(std::string_view what) {
        return arguments.NamedEntity(what, builder.ColorSpace());
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
