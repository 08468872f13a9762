#include "pbrt/materials/mix.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

constexpr ArrayParam kMaterials{"materials", "string", "an error",
                                "the names of two materials defined before"};
constexpr FloatParam kAmount{"amount", "", 0.5f, 0, 1, "share of the second material"};

MaterialId Find(const std::string &name, ParamDict &params, const NamedMaterials &named) {
    const auto found = named.find(name);
    if (found == named.end()) {
        std::vector<std::string_view> names;
        for (const auto &entry : named)
            names.push_back(entry.first);
        params.Error(kMaterials.name,
                     fmt::format("no named material \"{}\" is defined before its use "
                                 "here{}",
                                 name, DidYouMean(name, names)));
        return kMissingMaterialId;
    }
    if (found->second == kInterfaceId)
        params.Error(kMaterials.name,
                     fmt::format("\"{}\" is an interface, which cannot be mixed", name));
    return found->second;
}

}  // namespace

MixMaterial MixMaterial::Create(ParamDict &params, const NamedTextures &textures,
                                const NamedMaterials &named) {
    MixMaterial m;
    const std::vector<std::string> names = params.GetStringArray(kMaterials);
    if (names.size() == 2)
        m.materials = {Find(names[0], params, named), Find(names[1], params, named)};
    else if (!names.empty() || params.Loc(kMaterials.name) == params.Directive())  // not given
        params.Error(kMaterials.name, "\"materials\" needs the names of two materials");
    m.amount = {params, textures, kAmount};
    return m;
}

std::string MixMaterial::Warnings(const ClampCounts &counts) const {
    std::string text;
    amount.AddWarning(kName, counts, &text);
    return text;
}

}  // namespace pbrt
