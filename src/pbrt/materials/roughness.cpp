#include "pbrt/materials/roughness.h"

namespace pbrt {
namespace {

constexpr FloatParam kRoughness{"roughness", "", 0, 0, 1e6f, "microfacet roughness"};
constexpr FloatParam kURoughness{"uroughness", "", 0, 0, 1e6f, "roughness along dp/du"};
constexpr FloatParam kVRoughness{"vroughness", "", 0, 0, 1e6f, "roughness along dp/dv"};

}  // namespace

Roughness Roughness::Create(ParamDict &params, const NamedTextures &named) {
    const BoundedTexture both(params, named, kRoughness);
    const auto overridden = [&](const FloatParam &row) {
        const bool given = params.Has(row.name, "float") || params.Has(row.name, "texture");
        return given ? BoundedTexture(params, named, row) : both;
    };
    Roughness r;
    r.u = overridden(kURoughness);
    r.v = overridden(kVRoughness);
    r.remap = params.GetOneBool("remaproughness", true);
    return r;
}

std::string Roughness::Warnings(std::string_view owner) const {
    std::string along, across;
    u.AddRemark(owner, &along);
    v.AddRemark(owner, &across);
    if (along == across || across.empty()) return along;  // `roughness` is both
    return along.empty() ? across : along + "; " + across;
}

}  // namespace pbrt
