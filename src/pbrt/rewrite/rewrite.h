#pragma once

#include <string>
#include <vector>

#include "pbrt/util/diagnostics.h"

namespace pbrt::rewrite {

/// The ways to rewrite scene files: `pbrt --format`, `--toply` and `--upgrade`.
enum class Task {
    Format,   ///< the same, laid out anew
    ToPly,    ///< and large triangle meshes in PLY files beside the scene (to_ply.h)
    Upgrade,  ///< and pbrt-v3's names and parameters as pbrt-v4 has them (upgrade.h)
};

/// The new text of the files, one after the other ("-" or no file at all: standard input). As in
/// pbrt-v4, Include and Import stay as they are, and in every task WorldEnd is left out, the types
/// point, vector and color become point3, vector3 and rgb, and "true" and "false" lose their
/// quotes. Comments are kept; those between the values of a parameter move above it. Empty after an
/// error, which is reported with its place.
std::string RewriteFiles(const std::vector<std::string> &files, Task task, Diagnostics &log);
/// The same of one text; `name` stands for the file in messages, PLY files go to the folder `dir`.
std::string RewriteText(std::string_view text, std::string_view name, const std::string &dir,
                        Task task, Diagnostics &log);

}  // namespace pbrt::rewrite
