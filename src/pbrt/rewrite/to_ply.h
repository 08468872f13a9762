#pragma once

#include <optional>
#include <string>

#include "pbrt/rewrite/statement.h"

namespace pbrt::rewrite {

/// Turns `Shape "trianglemesh"` of 500 or more "indices" into "plymesh", as pbrt-v4 does. The files
/// stand in the scene's folder, so that the new scene belongs there, too: `mesh_00001.ply` and so
/// on, with the environment's PLY_PREFIX instead of `mesh`. A file of that name with other contents
/// is passed over. Meshes with "S", which PLY files cannot carry, and mistaken ones stay.
class ToPly {
  public:
    explicit ToPly(Diagnostics *log);

    /// The folder of the statements that follow; empty: the current one.
    void SetFolder(const std::string &name) { folder = name; }
    void Apply(Statement *s);

  private:
    /// The bytes in the first file with a name that is free; its name, or nullopt after an error.
    std::optional<std::string> Write(const std::string &bytes, const FileLoc &loc);

    Diagnostics *log;
    std::string prefix, folder;
    int count = 0;
};

}  // namespace pbrt::rewrite
