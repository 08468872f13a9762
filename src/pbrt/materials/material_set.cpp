#include "pbrt/materials/material_set.h"

#include "pbrt/materials/materials.h"

namespace pbrt {
namespace {

MaterialFacts FactsOf(const Material &material) {
    return Dispatch(material, [&]<typename M>(const M &m) {
        bool isUniform = false;
        if constexpr (M::kTraits.canBeUniform) isUniform = m.IsUniform();
        return MaterialFacts{uint8_t(material.index()), isUniform, M::kTraits.nullTransmission};
    });
}

}  // namespace

MaterialSet::MaterialSet() = default;
MaterialSet::MaterialSet(MaterialSet &&) noexcept = default;
MaterialSet &MaterialSet::operator=(MaterialSet &&) noexcept = default;
MaterialSet::~MaterialSet() = default;

void MaterialSet::Reserve(size_t count) {
    materials.reserve(count);
    facts.reserve(count);
}

int MaterialSet::Add(Material material) {
    facts.push_back(FactsOf(material));
    materials.push_back(std::move(material));
    return int(materials.size()) - 1;
}

std::string_view MaterialSet::LaidByUV(size_t i) const {
    return Dispatch(materials[i], []<typename M>(const M &m) -> std::string_view {
        if constexpr (M::kTraits.laidByUV)
            return m.LaidByUV();
        else
            return {};
    });
}

std::vector<std::string> MaterialSet::Warnings(const ClampCounts &counts) const {
    std::vector<std::string> sentences;
    for (const Material &material : materials) {
        Dispatch(material, [&]<typename M>(const M &m) {
            if constexpr (M::kTraits.warns)
                if (std::string text = m.Warnings(counts); !text.empty())
                    sentences.push_back(std::move(text));
        });
    }
    return sentences;
}

}  // namespace pbrt
