#pragma once

#include <gtest/gtest.h>

#include "bxdf/bxdf_case.h"
#include "feather/model.h"
#include "materials/material_examples.h"

namespace pbrt::test {

namespace detail {
template <typename List>
struct BxDFTypesOf;
template <typename... Ms>
struct BxDFTypesOf<TypeList<Ms...>> {
    using Types = testing::Types<BxDFOf<Ms>...>;
    /// Calls visit with the type of each material whose BxDF is B.
    template <typename B, typename F>
    static void ForMaterialsOf(F visit) {
        (
            [&]<typename M>() {
                if constexpr (std::same_as<BxDFOf<M>, B>) visit.template operator()<M>();
            }.template operator()<Ms>(),
            ...);
    }
};
}  // namespace detail

/// Every BxDF there is: those of the materials.
using BxDFTypes = detail::BxDFTypesOf<MaterialTypes>::Types;

/// The cases on which every law is tested. In general the BxDFs of the examples of their materials
/// (kExamples), with the claims of BxDFCase's defaults. Specialised below for types about which
/// more is claimed, or which have cases that no parameters reach.
template <typename B>
std::vector<BxDFCase<B>> CasesOf() {
    std::vector<BxDFCase<B>> cases;
    detail::BxDFTypesOf<MaterialTypes>::ForMaterialsOf<B>([&]<typename M>() {
        static const std::vector<MaterialExample> examples = MaterialExamples<M>();
        for (const MaterialExample &e : examples)
            cases.push_back({e.text, BxDFAt<M>(e)});
    });
    return cases;
}

inline SampledSpectrum Spectral(float a, float b, float c, float d) {
    return SampledSpectrum(std::array<float, 4>{a, b, c, d});
}

template <>
inline std::vector<BxDFCase<DiffuseBxDF>> CasesOf() {
    return {{"white", DiffuseBxDF(SampledSpectrum(1))},
            {"coloured", DiffuseBxDF(Spectral(0.1f, 0.5f, 0, 0.9f))}};
}

template <>
inline std::vector<BxDFCase<DiffuseTransmissionBxDF>> CasesOf() {
    const SampledSpectrum none(0), red = Spectral(0.1f, 0.2f, 0.7f, 0.4f);
    return {{"white", DiffuseTransmissionBxDF(SampledSpectrum(0.6f), SampledSpectrum(0.4f))},
            {"coloured", DiffuseTransmissionBxDF(red, Spectral(0.3f, 0, 0.2f, 0.1f))},
            {"only reflects", DiffuseTransmissionBxDF(red, none)},
            {"only transmits", DiffuseTransmissionBxDF(none, red)},
            {"black", DiffuseTransmissionBxDF(none, none)}};
}

template <>
inline std::vector<BxDFCase<CoatedDiffuseBxDF>> CasesOf() {
    static const Coat lossless(1.5f, 0, 0, 0), thin(1.5f, 0.01f, 0, 0), none(1, 0, 0, 0),
        rough(1.5f, 0.01f, 0.3f, 0.3f), brushed(1.8f, 0.5f, 0.1f, 0.4f),
        textured = Coat::ForTextures(1.5f, 0.01f);
    const SampledSpectrum white(1), red = Spectral(0.1f, 0.2f, 0.7f, 0.4f);
    return {{"smooth, white", CoatedDiffuseBxDF(white, lossless, 0, 0)},
            {"smooth, coloured", CoatedDiffuseBxDF(red, thin, 0, 0)},
            {"smooth, black", CoatedDiffuseBxDF(SampledSpectrum(0), thin, 0, 0)},
            {"index 1", CoatedDiffuseBxDF(white, none, 0, 0)},
            {"rough, white", CoatedDiffuseBxDF(white, rough, 0.3f, 0.3f)},
            {"rough, black", CoatedDiffuseBxDF(SampledSpectrum(0), rough, 0.3f, 0.3f)},
            {"brushed", CoatedDiffuseBxDF(red, brushed, 0.1f, 0.4f)},
            {"textured", CoatedDiffuseBxDF(white, textured, 0.05f, 0.4f)},
            {"very rough", CoatedDiffuseBxDF(red, textured, 3, 1)},
            {"nearly smooth", CoatedDiffuseBxDF(red, textured, 0.0012f, 0), 1, true, 0.05f}};
}

template <>
inline std::vector<BxDFCase<ConductorBxDF>> CasesOf() {
    const SampledSpectrum eta = Spectral(2, 0.2f, 1, 0.05f), k = Spectral(4, 3.9f, 0.5f, 8);
    // Widths of pbrt-v4's chi-square tests, and beyond.
    const float half = std::sqrt(0.5f), third = std::sqrt(0.3f), sixth = std::sqrt(0.15f);
    return {{"mirror", ConductorBxDF(eta, k, 0, 0)},
            {"isotropic", ConductorBxDF(eta, k, half, half)},
            {"anisotropic", ConductorBxDF(eta, k, third, sixth)},
            {"brushed", ConductorBxDF(eta, k, 0.05f, 0.4f)},
            {"nearly smooth", ConductorBxDF(eta, k, 0, 0.0011f), 1, true, 0.05f},
            {"very rough", ConductorBxDF(eta, k, 3, 30)},
            {"nothing there", ConductorBxDF(SampledSpectrum(1), SampledSpectrum(0), 0.3f, 0.3f)}};
}

template <>
inline std::vector<BxDFCase<DielectricBxDF>> CasesOf() {
    const float half = std::sqrt(0.5f), third = std::sqrt(0.3f), sixth = std::sqrt(0.15f);
    const float inv = 1 / 1.5f;
    return {{"smooth", DielectricBxDF(1.5f, 0, 0), 1.5f},
            {"smooth, dense outside", DielectricBxDF(inv, 0, 0), inv},
            {"index 1", DielectricBxDF(1, 0.3f, 0.3f), 1},
            {"isotropic", DielectricBxDF(1.5f, half, half), 1.5f},
            {"anisotropic", DielectricBxDF(1.5f, third, sixth), 1.5f},
            {"isotropic, dense outside", DielectricBxDF(inv, half, half), inv},
            {"anisotropic, dense outside", DielectricBxDF(inv, third, sixth), inv},
            {"index 1.05", DielectricBxDF(1.05f, 0.2f, 0.3f), 1.05f},
            {"index 4", DielectricBxDF(4, 0.1f, 0.2f), 4},
            {"nearly smooth", DielectricBxDF(1.5f, 0.0011f, 0), 1.5f, true, 0.1f},
            {"very rough", DielectricBxDF(1.5f, 3, 30), 1.5f}};
}

template <>
inline std::vector<BxDFCase<HairBxDF>> CasesOf() {
    // Attenuation is a function of wo alone, so the model is not reciprocal.
    const auto hair = [](const char *name, float h, float beta_m, float beta_n, float alpha,
                         SampledSpectrum sigma_a, float tolerance = 1e-3f) {
        return BxDFCase<HairBxDF>{name, HairBxDF(h, 1.55f, sigma_a, beta_m, beta_n, alpha), 1,
                                  false, tolerance};
    };
    const SampledSpectrum none(0), brown = Spectral(0.4f, 0.7f, 1.4f, 0.1f);
    return {hair("default", 0.3f, 0.3f, 0.3f, 2, brown),
            hair("off centre", -0.9f, 0.25f, 0.15f, 2, brown),
            hair("rough", 0.1f, 0.9f, 0.8f, -4, none),
            hair("roughest", 0, 1, 1, 0, none),
            hair("sharpest", 0.5f, 0.01f, 0.01f, 2, brown, 0.05f),
            hair("sharp around", 0.2f, 0.5f, 0.01f, 2, none, 0.05f),
            hair("sharp along", 0.7f, 0.01f, 0.6f, 10, none, 0.05f),
            hair("black", 0.4f, 0.3f, 0.3f, 2, SampledSpectrum(1e6f)),
            hair("edge", 1, 0.2f, 0.3f, 2, brown)};
}

template <>
inline std::vector<BxDFCase<FeatherBarbuleBxDF>> CasesOf() {
    const auto feather = [](const char *name, const feather::Shape &shape,
                            const feather::Optics<float, 4> &optics = feather::Feather<float>()) {
        return BxDFCase<FeatherBarbuleBxDF>{
            name, FeatherBarbuleBxDF(feather::BarbuleOf<float>(shape, optics))};
    };
    feather::Optics<float, 4> pigment = feather::Feather<float>(), film = pigment;
    pigment.eta.fill(1);
    pigment.melanin.fill(1);
    film.melanin.fill(0);
    return {feather("default", {}),
            feather("round, intersecting", {.aspect = 1}),
            feather("sparse, film alone", {.spacing = 2.5}, film),
            feather("steep, strongly bent", {.spacing = 2.5, .tilt = -0.8, .opening = 0.9}),
            feather("uneven film", {.spacing = 1.6, .roughness = 25}),
            feather("pigment alone", {.spacing = 1.9, .opening = 0.3}, pigment)};
}

}  // namespace pbrt::test
