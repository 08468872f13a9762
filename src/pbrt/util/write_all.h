#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pbrt {

/// Whether writing to a pipe that nobody reads any more ends the process, as is usual for standard
/// output, or is an error like any other.
enum class BrokenPipe { Kills, Fails };

/// Writes all bytes; returns errno's value, 0 where all is well. A file that grows beyond its limit
/// (RLIMIT_FSIZE) is an error, EFBIG, and no signal.
int WriteAll(int fd, std::string_view bytes, BrokenPipe brokenPipe);

/// Writes to standard output, or returns the reason why not all of it could be written.
std::optional<std::string> WriteStandardOutput(std::string_view text);

}  // namespace pbrt
