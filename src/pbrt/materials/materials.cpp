#include "pbrt/materials/materials.h"

#include "pbrt/materials/mix.h"

namespace pbrt {

std::vector<std::string_view> MaterialNames() {
    std::vector<std::string_view> names(MaterialTypes::kNames.begin(), MaterialTypes::kNames.end());
    names.insert(names.end(), {MixMaterial::kName, InterfaceMaterial::kName});
    return names;
}

std::optional<Material> CreateMaterial(std::string_view type, ParamDict &params,
                                       const NamedTextures &named) {
    std::optional<Material> material;
    const bool known = MaterialTypes::Visit(type, [&]<typename M>() {
        material.emplace(M::Create(params, named));
        if constexpr (M::kTraits.fibre)
            BumpMap::Ignore(params);
        else
            material->bump = BumpMap::Create(params, named);
    });
    if (!known) {
        const std::vector<std::string_view> names = MaterialNames();
        params.Error(UnknownName("material", type, names));
        return {};
    }
    params.ReportUnused();
    return material;
}

}  // namespace pbrt
