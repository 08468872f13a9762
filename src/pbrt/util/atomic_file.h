#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pbrt {

/// Replaces the file `fileName` by `contents`, all or nothing: the bytes go to a temporary name in
/// the same folder, are flushed to the disk and renamed. On failure the temporary file is removed
/// and an old file is untouched. A symbolic link is followed; what is no regular file (a pipe,
/// /dev/null) is written in place. Returns the reason on failure, a sentence with the file's name.
std::optional<std::string> WriteFileAtomically(const std::string &fileName,
                                               std::string_view contents);

/// The reason why WriteFileAtomically would fail at once (no such folder, no right to write, a
/// folder of this name), to be asked before a long computation; nothing is left behind.
std::optional<std::string> WhyNotWritable(const std::string &fileName);

/// The whole of a file as bytes, or the reason as a sentence with the file's name.
struct FileContents {
    std::optional<std::string> bytes;
    std::string error;
};
FileContents ReadWholeFile(const std::string &fileName);

}  // namespace pbrt
