#include "pbrt/materials/bounded_texture.h"

#include <fmt/format.h>

namespace pbrt {

void BoundedTexture::AddWarning(std::string_view owner, const ClampCounts &counts,
                                std::string *warnings) const {
    const int64_t n = range ? counts.Of(range.get()) : 0;
    if (n == 0) return;
    const FloatParam &row = *range;
    *warnings += fmt::format("{}{} \"{}\": {} texture values outside [{}, {}]{}{} clamped",
                             warnings->empty() ? "" : "; ", owner, row.name, n, row.lo, row.hi,
                             row.unit.empty() ? "" : " ", row.unit);
}

}  // namespace pbrt
