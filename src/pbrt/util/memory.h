#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pbrt {

/// Bytes that this process may still take: the least of what its own limits (RLIMIT_AS,
/// RLIMIT_DATA), its control groups (v1 and v2, with all above them) and the machine leave. What
/// the kernel keeps of files counts as free, swap as memory. What cannot be read limits nothing.
/// Reads some files of /proc: about 0.1 ms.
uint64_t AvailableMemory();

/// "needs 57 GB of memory, 20 GB are left", where `bytes` are more than AvailableMemory(); to be
/// asked before much is taken at a user's wish, and put behind what needs it.
std::optional<std::string> WhyTooLarge(uint64_t bytes);

/// "57 GB", "1.5 MB": two digits and a power of 1000.
std::string ByteText(uint64_t bytes);

/// The number of bytes that "4G", "4GB", "1.5 g" or "200000" mean; K, M, G, T are powers of 1000.
std::optional<uint64_t> ParseBytes(std::string_view text);

/// Lets this process have at most `bytes` of memory from now on, by RLIMIT_DATA, which counts what
/// is written to and neither programs nor address space that is only reserved. Returns the reason
/// where the system refuses. What is used already stays.
std::optional<std::string> LimitMemory(uint64_t bytes);

}  // namespace pbrt
