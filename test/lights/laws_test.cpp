// Laws of every type of light, on the examples in its header.

#include "lights/light_cases.h"
#include "pbrt/lights/light_bounds.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt::test {
namespace {

template <typename L>
class EveryLight : public testing::Test {};
TYPED_TEST_SUITE(EveryLight, TestTypesOf<LightTypes>);

Vector3f Direction(Rng &rng) {
    return SampleUniformSphere(rng.Uniform2D());
}
SampledWavelengths Wavelengths(Rng &rng) {
    return SampledWavelengths::SampleVisible(rng.Uniform());
}
/// The CIE-Y integral of what has radiance L at these wavelengths, in the mean over wavelengths.
double Luminance(const SampledSpectrum &L, const SampledWavelengths &lambda) {
    const SampledSpectrum pdf = lambda.PDF(), y = spectra::Y().Sample(lambda);
    double sum = 0;
    for (int i = 0; i < NSpectrumSamples; ++i)
        sum += pdf[i] == 0 ? 0 : double(L[i]) * y[i] / pdf[i];
    return sum / NSpectrumSamples;
}

/// f(case, context, wavelengths, sample) for samples of each example from places in the scene.
template <typename L, typename F>
void ForEachSample(uint64_t seed, F f) {
    Rng rng(seed);
    for (const LightCase &c : CasesOf<L>()) {
        int samples = 0;
        for (int i = 0; i < 4000; ++i) {
            const LightSampleContext ctx{5.f * rng.Uniform() * Direction(rng), {}};
            const SampledWavelengths lambda = Wavelengths(rng);
            const auto s = SampleLi(c.light, ctx, rng.Uniform2D(), lambda);
            if (!s) continue;
            ++samples;
            f(c, ctx, lambda, *s);
        }
        EXPECT_EQ(samples > 20, !L::kTraits.neverSampled) << c.text;
    }
}

TYPED_TEST(EveryLight, ExamplesAreOfItsType) {
    for (const LightCase &c : CasesOf<TypeParam>())
        EXPECT_TRUE(std::holds_alternative<TypeParam>(c.light)) << c.text;
}

TYPED_TEST(EveryLight, SamplesAreWhatTheyMustBe) {
    ForEachSample<TypeParam>(1, [](const LightCase &c, const LightSampleContext &ctx,
                                   const SampledWavelengths &, const LightLiSample &s) {
        EXPECT_NEAR(Length(s.wi), 1, 1e-5f) << c.text;
        EXPECT_TRUE(s.pdf > 0 && s.pdf < Infinity) << c.text;
        EXPECT_TRUE(s.L.IsFinite()) << c.text;
        for (int k = 0; k < NSpectrumSamples; ++k)
            EXPECT_GE(s.L[k], 0) << c.text;
        // The shadow ray's end lies where the sample comes from.
        const Vector3f to = s.pLight - ctx.p;
        EXPECT_LE(Length(Cross(to, s.wi)), 1e-4f * (1 + Length(to))) << c.text;
        EXPECT_GT(Dot(to, s.wi), 0) << c.text;
        if (TypeParam::kTraits.isDelta) {
            EXPECT_TRUE(s.delta) << c.text;
            EXPECT_EQ(s.pdf, 1) << c.text;
        }
    });
}

TYPED_TEST(EveryLight, BoundsHoldWhatIsSampled) {
    ForEachSample<TypeParam>(2, [](const LightCase &c, const LightSampleContext &ctx,
                                   const SampledWavelengths &, const LightLiSample &s) {
        const auto bounds = Bounds(c.light);
        if (!bounds) {
            // From infinity: shadow rays leave the scene.
            EXPECT_GE(Length(s.pLight - ctx.p), 2 * kSceneRadius * (1 - 1e-5f)) << c.text;
            return;
        }
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(s.pLight[k], bounds->bounds.min[k] - 1e-4f) << c.text;
            EXPECT_LE(s.pLight[k], bounds->bounds.max[k] + 1e-4f) << c.text;
        }
        const bool shines(s.L);
        EXPECT_TRUE(!shines || Importance(*bounds, ctx.p, {}) > 0) << c.text;
    });
}

TYPED_TEST(EveryLight, InfiniteOnesAreSeenAsTheyAreSampled) {
    using L = TypeParam;
    if constexpr (!L::kTraits.isInfinite) GTEST_SKIP() << "is not infinite";
    int samples = 0, agree = 0;
    ForEachSample<L>(3, [&](const LightCase &c, const LightSampleContext &ctx,
                            const SampledWavelengths &lambda, const LightLiSample &s) {
        ++samples;
        const SampledSpectrum Le = pbrt::Le(c.light, Ray{ctx.p, s.wi}, lambda);
        bool same = std::abs(PDF_Li(c.light, ctx.p, s.wi) / s.pdf - 1) < 1e-3f;
        for (int k = 0; k < NSpectrumSamples; ++k)
            same &= std::abs(Le[k] - s.L[k]) <= 1e-3f * s.L[k];
        agree += same;
    });
    // Rounding moves points at a texel's border into its neighbour.
    EXPECT_GE(agree, 0.99 * samples);
}

TYPED_TEST(EveryLight, InfiniteOnesHaveADensity) {
    using L = TypeParam;
    if constexpr (!L::kTraits.isInfinite) GTEST_SKIP() << "is not infinite";
    Rng rng(4);
    for (const LightCase &c : CasesOf<L>()) {
        // Over strata of the sphere: 1e-3 where texels' borders cut them.
        constexpr int n = 512;
        double sum = 0;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const Point2f u{(float(x) + rng.Uniform()) / n, (float(y) + rng.Uniform()) / n};
                sum += double(PDF_Li(c.light, {0, 0, 0}, SampleUniformSphere(u)));
            }
        EXPECT_NEAR(sum * 4 * double(Pi) / (n * n), L::kTraits.neverSampled ? 0 : 1, 5e-3)
            << c.text;
    }
}

/// Flux of all wavelengths, of which Power is to be of the same size.
double MeasuredPower(const LightCase &c) {
    Rng rng(5);
    const bool infinite = Traits(c.light).isInfinite, bounded = Bounds(c.light).has_value();
    constexpr int n = 20000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const SampledWavelengths lambda = Wavelengths(rng);
        const Vector3f w = Direction(rng);
        if (infinite) {
            sum += 4 * double(Pi) * Luminance(Le(c.light, Ray{{}, w}, lambda), lambda);
            continue;
        }
        // Through a sphere about all that is bounded; what is not, at the scene's middle.
        const float radius = bounded ? 50 : 0;
        const auto s = SampleLi(c.light, {radius * w, {}}, rng.Uniform2D(), lambda);
        if (!s) continue;
        const double cosine = bounded ? double(-Dot(s->wi, w)) : 1;
        sum += cosine * Luminance(s->L, lambda) / double(s->pdf) *
               (bounded ? 4 * double(Pi) * double(Sqr(radius)) : 1);
    }
    // Light from infinity falls on the scene's disk.
    return sum / n * (bounded ? 1 : double(Pi * Sqr(kSceneRadius)));
}

TYPED_TEST(EveryLight, PowerIsOfTheSizeOfTheFlux) {
    for (const LightCase &c : CasesOf<TypeParam>()) {
        const double measured = MeasuredPower(c);
        EXPECT_GT(measured, 0) << c.text;
        EXPECT_LT(double(Power(c.light)), 4 * measured) << c.text;
        EXPECT_GT(double(Power(c.light)), measured / 4) << c.text;
    }
}

}  // namespace
}  // namespace pbrt::test
