#include "pbrt/util/unpacked.h"

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/util/memory.h"

namespace pbrt {

namespace {
constexpr uint64_t kFree = uint64_t(64) << 20, kRatio = 200;
}

uint64_t MostUnpacked(uint64_t packed) {
    return std::max(kFree, kRatio * packed);
}

std::optional<std::string> WhyUnpackedTooLarge(uint64_t unpacked, uint64_t packed) {
    if (unpacked <= MostUnpacked(packed)) return {};
    return fmt::format("unpacks to more than {} and {} times its size ({}), which is refused",
                       ByteText(kFree), kRatio, ByteText(packed));
}

}  // namespace pbrt
