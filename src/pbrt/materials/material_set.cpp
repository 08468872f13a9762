#include "pbrt/materials/material_set.h"

#include "pbrt/materials/materials.h"

namespace pbrt {
namespace {

MaterialFacts FactsOf(const Material &material) {
    return Dispatch(material, [&]<typename M>(const M &m) {
        bool isUniform = false;
        if constexpr (M::kTraits.canBeUniform) isUniform = m.IsUniform() && !material.bump;
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
    anyBump |= material.bump != nullptr;
    materials.push_back(std::move(material));
    return int(materials.size()) - 1;
}

bool MaterialSet::BumpReadsUV(size_t i) const {
    return materials[i].bump && materials[i].bump->ReadsUV();
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
