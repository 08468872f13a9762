// Every material, by its examples.

#include <algorithm>

#include "materials/material_examples.h"
#include "pbrt/materials/material_set.h"
#include "pbrt/util/rng.h"

namespace pbrt::test {
namespace {

template <typename M>
class EveryMaterial : public testing::Test {};
template <typename List>
struct TypesOf;
template <typename... Ms>
struct TypesOf<TypeList<Ms...>> {
    using Types = testing::Types<Ms...>;
};
TYPED_TEST_SUITE(EveryMaterial, TypesOf<MaterialTypes>::Types);

TYPED_TEST(EveryMaterial, ExamplesAreReadWithoutAMessage) {
    EXPECT_GT(MaterialExamples<TypeParam>().size(), 0u);
}

TYPED_TEST(EveryMaterial, UniformOnesAreTheSameEverywhere) {
    if constexpr (TypeParam::kTraits.canBeUniform) {
        for (const MaterialExample &e : MaterialExamples<TypeParam>()) {
            const auto &material = std::get<TypeParam>(*e.made->material);
            if (!material.IsUniform()) continue;
            SampledWavelengths lambda = SampledWavelengths::Of({430, 510, 590, 670});
            const auto here = material.GetBxDF({}, lambda);
            const auto there = material.GetBxDF(AtUV(0.7f, 0.1f), lambda);
            const Vector3f wo = Normalize(Vector3f{0.3f, -0.2f, 0.8f}),
                           wi = Normalize(Vector3f{-0.4f, 0.5f, 0.6f});
            const SampledSpectrum a = here.f(wo, wi, TransportMode::Radiance),
                                  b = there.f(wo, wi, TransportMode::Radiance);
            for (int k = 0; k < NSpectrumSamples; ++k)
                EXPECT_EQ(a[k], b[k]) << e.text;
            EXPECT_EQ(here.PDF(wo, wi, TransportMode::Radiance),
                      there.PDF(wo, wi, TransportMode::Radiance))
                << e.text;
        }
    }
}

/// With one lobe no uc changes the sample.
TYPED_TEST(EveryMaterial, OneLobeReadsNoUc) {
    if constexpr (TypeParam::kTraits.oneLobe) {
        Rng rng(3);
        for (const MaterialExample &e : MaterialExamples<TypeParam>()) {
            const auto bxdf = BxDFAt<TypeParam>(e);
            for (int i = 0; i < 100; ++i) {
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
                const Point2f u = rng.Uniform2D();
                const auto a = bxdf.Sample_f(wo, 0, u, TransportMode::Radiance);
                const auto b = bxdf.Sample_f(wo, rng.Uniform(), u, TransportMode::Radiance);
                ASSERT_EQ(a.has_value(), b.has_value()) << e.text;
                if (!a) continue;
                EXPECT_EQ(a->wi, b->wi) << e.text;
                EXPECT_EQ(a->pdf, b->pdf) << e.text;
            }
        }
    }
}

/// Isotropic materials know no x axis: turning both directions about the normal changes f by
/// roundings only.
TYPED_TEST(EveryMaterial, IsotropicOnesHaveNoAxis) {
    if constexpr (TypeParam::kTraits.isotropic) {
        Rng rng(4);
        const auto turned = [](Vector3f w) { return Vector3f{-w.y, w.x, w.z}; };
        for (const MaterialExample &e : MaterialExamples<TypeParam>()) {
            const auto bxdf = BxDFAt<TypeParam>(e);
            for (int i = 0; i < 100; ++i) {
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D()),
                               wi = SampleUniformSphere(rng.Uniform2D());
                const SampledSpectrum a = bxdf.f(wo, wi, TransportMode::Radiance),
                                      b = bxdf.f(turned(wo), turned(wi), TransportMode::Radiance);
                for (int k = 0; k < NSpectrumSamples; ++k)
                    EXPECT_NEAR(a[k], b[k], 1e-4f * a[k]) << e.text;
            }
        }
    }
}

/// The share that passes straight through is how often it is sampled.
TYPED_TEST(EveryMaterial, NullTransmissionIsSampledAsOften) {
    if constexpr (TypeParam::kTraits.nullTransmission) {
        Rng rng(5);
        for (const MaterialExample &e : MaterialExamples<TypeParam>()) {
            const auto &material = std::get<TypeParam>(*e.made->material);
            const auto bxdf = BxDFAt<TypeParam>(e);
            for (int k = 0; k < 10; ++k) {
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
                const int n = 20000;
                double passed = 0, squares = 0;
                for (int i = 0; i < n; ++i) {
                    const auto s =
                        bxdf.Sample_f(wo, rng.Uniform(), rng.Uniform2D(), TransportMode::Radiance);
                    if (!s || !Has(s->flags, BxDFFlags::NullTransmission)) continue;
                    const double weight = s->f[0] * std::abs(s->wi.z) / s->pdf;
                    passed += weight, squares += weight * weight;
                }
                const double mean = passed / n, variance = squares / n - mean * mean;
                // Five standard errors; roundings where nothing is left to chance.
                EXPECT_NEAR(material.NullTransmission(AtUV(0.5f, 0.5f), wo), mean,
                            5 * std::sqrt(std::max(variance, 0.0) / n) + 1e-4)
                    << e.text;
            }
        }
    }
}

TEST(Materials, HaveDifferentNames) {
    std::vector<std::string_view> names = MaterialNames();
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(MaterialSet, KnowsTypesAndTraits) {
    MaterialSet set;
    for (int round = 0; round < 2; ++round) {
        MaterialTypes::ForEach([&]<typename M>() {
            const MaterialExample e = MaterialExamples<M>()[0];
            const auto i = size_t(set.Add(*e.made->material));
            EXPECT_EQ(set.Data()[i].index(), set.Facts(i).type);
            EXPECT_TRUE(std::holds_alternative<M>(set.Data()[i]));
            EXPECT_EQ(set.Facts(i).nullTransmission, M::kTraits.nullTransmission);
        });
    }
    EXPECT_EQ(set.Size(), 2 * MaterialTypes::kNames.size());
    EXPECT_TRUE(set.Warnings({}).empty());
    const MaterialSet moved = std::move(set);
    EXPECT_EQ(moved.Size(), 2 * MaterialTypes::kNames.size());
}

}  // namespace
}  // namespace pbrt::test
