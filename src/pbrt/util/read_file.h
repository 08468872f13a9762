#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace pbrt {

/// Whether a reader takes pipes. What a scene names is a regular file: a pipe would be waited for
/// without end. What a command line names may come from `<(...)`.
enum class Pipes { Refused, Taken };

/// The whole of a file as bytes, or why there are none.
struct FileContents {
    std::optional<std::string> bytes;
    std::string error;   ///< a sentence with the file's name
    std::string reason;  ///< the same without the name, to follow "cannot read NAME: "
};

/// Reads a regular file or, where they are taken, a pipe to its end. Refused are folders, devices
/// (they have no end), what holds more than `most` bytes and what there is no memory for; a size is
/// judged before memory is taken.
FileContents ReadWholeFile(const std::string &fileName, Pipes pipes = Pipes::Refused,
                           uint64_t most = std::numeric_limits<uint64_t>::max());
/// Why there is nothing to read by this name: "No such file or directory", "it is a device;
/// expected a file". Without opening it, which would wait for a pipe's other end.
std::optional<std::string> WhyNoFile(const std::string &fileName, Pipes pipes = Pipes::Refused);
/// Standard input to its end, which may be a terminal's.
FileContents ReadStandardInput();

}  // namespace pbrt
