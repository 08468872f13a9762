// Every texture, by its examples.

#include <fmt/format.h>

#include "pbrt/image/image.h"
#include "pbrt/ptex/texture.h"
#include "pbrt/textures/textures.h"
#include "pbrt/util/rng.h"
#include "support/temp_folder.h"
#include "textures/texture_scene.h"

namespace pbrt::test {
namespace {

const SampledWavelengths kLambda = SampledWavelengths::SampleVisible(0.3f);

template <typename T>
class EveryTexture : public TempFolder {
  protected:
    void SetUp() override {
        TempFolder::SetUp();
        Image image({2, 2}, {"R", "G", "B"});
        for (int i = 0; i < 4; ++i)
            for (int c = 0; c < 3; ++c)
                image.Set({i % 2, i / 2}, c, float(i * 3 + c) / 12);
        EXPECT_EQ(WriteImage(image, Path("example.exr"), ExrPixels::Float), std::nullopt);
        EXPECT_EQ(WritePtex(Path("example.ptx"), ConstantPtex(3, {0.1f, 0.3f, 0.8f})),
                  std::nullopt);
    }
    /// Texture "t", read without a message.
    TextureScene Made(std::string_view example, std::string_view kind) const {
        const std::string text =
            fmt::format("Texture \"t\" \"{}\" \"{}\" {}", kind, T::kName, example);
        TextureScene scene(text, folder.string());
        EXPECT_EQ(scene.Messages(), "") << text;
        return scene;
    }
    static std::vector<TextureEvalContext> Contexts() {
        Rng rng(1);
        const auto signedNumber = [&] { return 20 * rng.Uniform() - 10; };
        std::vector<TextureEvalContext> contexts(100);
        for (TextureEvalContext &c : contexts) {
            c.p = {signedNumber(), signedNumber(), signedNumber()};
            c.n = {0, 0, 1};
            c.uv = {signedNumber(), signedNumber()};
            c.dpdx = {rng.Uniform(), 0, 0}, c.dpdy = {0, rng.Uniform(), 0};
            c.dudx = rng.Uniform(), c.dvdy = rng.Uniform();
        }
        return contexts;
    }
};

template <typename List>
struct TypesOf;
template <typename... Ts>
struct TypesOf<TypeList<Ts...>> {
    using Types = testing::Types<Ts...>;
};
TYPED_TEST_SUITE(EveryTexture, TypesOf<TextureTypes>::Types);

TYPED_TEST(EveryTexture, FloatsAreFiniteAndAlwaysTheSame) {
    for (const std::string_view example : TypeParam::kExamples) {
        const TextureScene made = this->Made(example, "float");
        for (const TextureEvalContext &ctx : this->Contexts()) {
            const float v = made.Float("t").Evaluate(ctx);
            EXPECT_TRUE(std::isfinite(v)) << example;
            EXPECT_EQ(v, made.Float("t").Evaluate(ctx)) << example;
        }
    }
}

TYPED_TEST(EveryTexture, SpectraLieInTheRangeOfTheirRole) {
    if constexpr (FloatOnlyTexture<TypeParam>) return;
    for (const std::string_view example : TypeParam::kExamples) {
        const TextureScene made = this->Made(example, "spectrum");
        for (const SpectrumType role :
             {SpectrumType::Albedo, SpectrumType::Unbounded, SpectrumType::Illuminant}) {
            for (const TextureEvalContext &ctx : this->Contexts()) {
                const SampledSpectrum s = made.Spectrum("t", role).Evaluate(ctx, kLambda);
                EXPECT_TRUE(s.IsFinite()) << example;
                for (int k = 0; k < NSpectrumSamples; ++k) {
                    EXPECT_GE(s[k], 0) << example;
                    if (role == SpectrumType::Albedo) {
                        EXPECT_LE(s[k], 1) << example;
                    }
                }
            }
        }
    }
}

/// Textures that do not say they read uv or the steps per pixel do not.
TYPED_TEST(EveryTexture, ReadsNoMoreThanItSays) {
    for (const std::string_view example : TypeParam::kExamples) {
        const TextureScene made = this->Made(example, "float");
        for (const TextureEvalContext &ctx : this->Contexts()) {
            const float v = made.Float("t").Evaluate(ctx);
            if (!made.named.readUV.contains("t")) {
                TextureEvalContext other = ctx;
                other.uv = {0.25f, 0.75f};
                EXPECT_EQ(made.Float("t").Evaluate(other), v) << example;
            }
            if (!made.named.readFootprints) {
                TextureEvalContext other = ctx;
                static_cast<TextureFootprint<float> &>(other) = {};
                EXPECT_EQ(made.Float("t").Evaluate(other), v) << example;
            }
        }
    }
}

}  // namespace
}  // namespace pbrt::test
