#pragma once

#include <string>
#include <string_view>

#include "pbrt/ptex/native/layout.h"

namespace pbrt {

/// Whether `zipped` bytes of zlib's can become `size` bytes at all: it never does better than 1032.
inline bool CanInflate(uint64_t zipped, uint64_t size) {
    return size <= 1032 * zipped + 64;
}
/// Inflates to exactly `size` bytes; false where the data are damaged, shorter or longer.
bool Inflate(std::string_view zipped, void *to, size_t size);

/// The block of one face on one level.
struct PtexBlock {
    PtexBlockHeader header;
    std::string_view bytes;  ///< header.Size() of them
    int log2U, log2V;
};

/// Why the block cannot be decoded, as far as its sizes tell; empty where they fit. Adds the bytes
/// of texels that need none in the file.
std::string CheckPtexBlock(const PtexBlock &block, const PtexTexels &layout,
                           uint64_t *constantBytes);
/// Decodes a block that passed CheckPtexBlock. `color`: a pixel, where a constant block has none.
/// The reason on failure.
std::string DecodePtexBlock(const PtexBlock &block, const PtexTexels &layout,
                            const std::byte *color, std::byte *to);

}  // namespace pbrt
