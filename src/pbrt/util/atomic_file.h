#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pbrt {

/// Replaces the file `fileName` by `contents`, all or nothing: the bytes go to a file without a
/// name in the same folder (of a temporary name where the file system has no such files), are
/// flushed to the disk and take the name; so a process that is killed leaves nothing behind. On
/// failure an old file is untouched. Symbolic links stay and are written through, even where they
/// lead to no file yet. What is no regular file (a pipe, /dev/null) is written in place. A file
/// that nobody may write (mode 444), or not this user, is refused though its folder would allow it.
/// Returns the reason on failure, a sentence with the file's name.
std::optional<std::string> WriteFileAtomically(const std::string &fileName,
                                               std::string_view contents);

/// The reason why WriteFileAtomically would fail at once (no such folder, no right to write, a
/// folder of this name), to be asked before a long computation; nothing is left behind.
std::optional<std::string> WhyNotWritable(const std::string &fileName);

}  // namespace pbrt
