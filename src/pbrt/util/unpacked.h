#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace pbrt {

/// Most bytes that are taken from `packed` compressed ones: 64 MiB, or 200 times as many. Scenes
/// and meshes take 3 to 30 times their packed size; deflate reaches 1032.
uint64_t MostUnpacked(uint64_t packed);

/// Why no more is unpacked, as the rest of a sentence, where `unpacked` bytes are beyond that.
std::optional<std::string> WhyUnpackedTooLarge(uint64_t unpacked, uint64_t packed);

}  // namespace pbrt
