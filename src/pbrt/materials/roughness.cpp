#include "pbrt/materials/roughness.h"

namespace pbrt {
namespace {

constexpr NumberRow kRoughness{"roughness", "", 0, 0, 1e6f, "microfacet roughness"};
constexpr NumberRow kURoughness{"uroughness", "", 0, 0, 1e6f, "roughness along dp/du"};
constexpr NumberRow kVRoughness{"vroughness", "", 0, 0, 1e6f, "roughness along dp/dv"};

}  // namespace

Roughness Roughness::Create(ParamDict &params, const NamedTextures &named) {
    const FloatTexture both = GetFloatTexture(params, named, kRoughness);
    const auto overridden = [&](const NumberRow &row) {
        const bool given = params.Has(row.name, "float") || params.Has(row.name, "texture");
        return given ? GetFloatTexture(params, named, row) : both;
    };
    Roughness r;
    r.u = overridden(kURoughness);
    r.v = overridden(kVRoughness);
    r.remap = params.GetOneBool("remaproughness", true);
    return r;
}

}  // namespace pbrt
