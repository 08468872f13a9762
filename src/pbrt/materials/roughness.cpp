#include "pbrt/materials/roughness.h"

namespace pbrt {
namespace {

constexpr BoolParam kRemap{"remaproughness", true,
                           "microfacet alpha is the square root of the roughness, not itself"};

}  // namespace

const RoughnessRows kRoughnessRows{
    {"roughness", "", 0, 0, 1e6f, "microfacet roughness; 0: smooth"},
    {"uroughness", "", 0, 0, 1e6f, "roughness along dp/du; not given: roughness"},
    {"vroughness", "", 0, 0, 1e6f, "roughness along dp/dv; not given: roughness"}};

Roughness Roughness::Create(ParamDict &params, const NamedTextures &named,
                            const RoughnessRows &rows) {
    const BoundedTexture both(params, named, rows.both);
    const auto overridden = [&](const FloatParam &row) {
        return params.HasOrTexture(row) ? BoundedTexture(params, named, row) : both;
    };
    Roughness r;
    r.u = overridden(rows.u);
    r.v = overridden(rows.v);
    r.remap = params.GetOneBool(kRemap);
    return r;
}

std::string Roughness::Warnings(std::string_view owner, const ClampCounts &counts) const {
    std::string along, across;
    u.AddWarning(owner, counts, &along);
    v.AddWarning(owner, counts, &across);
    if (along == across || across.empty()) return along;  // `roughness` is both
    return along.empty() ? across : along + "; " + across;
}

}  // namespace pbrt
