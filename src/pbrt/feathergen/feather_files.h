#pragma once

#include <string>

#include "pbrt/feathergen/feather.h"
#include "pbrt/feathergen/file_set.h"

namespace pbrt::feathergen {

enum class TextureFiles { Atlas, Ptex };

/// Folder of a feather's files, and the beginning of their names.
struct FeatherNames {
    std::string folder;  ///< as the scene names it; "" or with a slash at its end
    std::string prefix;  ///< of file names, and of the textures' names in the scene
    TextureFiles textures = TextureFiles::Atlas;

    std::string Path(std::string_view name) const { return folder + prefix + std::string(name); }
};

/// Adds the feather's meshes and textures to `files`.
void AddFeatherFiles(const Feather &feather, const FeatherNames &names, FileSet *files);

/// Directives that define the feather's textures.
std::string TextureDirectives(const FeatherNames &names);
/// Its materials and shapes, in the current transform; changes the current material.
std::string ShapeDirectives(const Parameters &parameters, const FeatherNames &names);

/// Writer of a file set for plain text.
FileSet::Writer TextWriter(std::string text);

}  // namespace pbrt::feathergen
