#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pbrt/util/diagnostics.h"
#include "pbrt/util/read_file.h"

namespace pbrt {

/// The bytes of a file, `.gz` (case ignored) decompressed, `-` being standard input. Reading
/// errors, truncated or damaged compressed data, a size beyond WhyUnpackedTooLarge and want of
/// memory are errors at `use`, the place that asks for the file.
std::optional<std::string> ReadFileContents(const std::string &path, Pipes pipes,
                                            const FileLoc &use, Diagnostics &log);

/// The contents of a gzip file, all its members; nullopt and `why` where it is damaged or too
/// large.
std::optional<std::string> Gunzip(std::string_view compressed, std::string &why);

/// `name` inside folder `dir` where such a file exists, else `name` itself (so found from the
/// current folder). Absolute names and an empty `dir` leave it as it is.
std::string ResolvePath(std::string_view name, std::string_view dir);
/// Folder of a file: what precedes the last slash, empty where there is none.
std::string FolderOf(std::string_view path);

}  // namespace pbrt
