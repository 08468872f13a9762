#include "pbrt/materials/bounded_texture.h"

#include <fmt/format.h>

namespace pbrt {

void BoundedTexture::AddRemark(std::string_view owner, std::string *remarks) const {
    const int64_t n = range ? range->clamped.load() : 0;
    if (n == 0) return;
    const FloatParam &row = range->row;
    *remarks += fmt::format("{}{} \"{}\": {} texture values outside [{}, {}]{}{} clamped",
                            remarks->empty() ? "" : "; ", owner, row.name, n, row.lo, row.hi,
                            row.unit.empty() ? "" : " ", row.unit);
}

}  // namespace pbrt
