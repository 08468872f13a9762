// Contracts refuse types that are nearly right: a member that is announced and missing, misspelt or
// of another type, or that is there and not announced.

#include <gtest/gtest.h>

#include "pbrt/base/material.h"
#include "pbrt/base/sampler.h"
#include "pbrt/scene/params.h"

namespace pbrt {
namespace {

struct GoodBxDF {
    static constexpr BxDFTraits kTraits{};
    BxDFFlags Flags() const { return BxDFFlags::Unset; }
    SampledSpectrum f(Vector3f, Vector3f, TransportMode) const { return SampledSpectrum(0); }
    float PDF(Vector3f, Vector3f, TransportMode) const { return 0; }
    std::optional<BSDFSample> Sample_f(Vector3f, float, Point2f, TransportMode) const { return {}; }
};
static_assert(BxDFType<GoodBxDF>);

struct AnnouncesRegularize : GoodBxDF {
    static constexpr BxDFTraits kTraits{.regularizes = true};
    void Regularise() {}
};
static_assert(!BxDFType<AnnouncesRegularize>);
struct HidesRegularize : GoodBxDF {
    void Regularize() {}
};
static_assert(!BxDFType<HidesRegularize>);
struct RegularizesAsAnnounced : GoodBxDF {
    static constexpr BxDFTraits kTraits{.regularizes = true};
    void Regularize() {}
};
static_assert(BxDFType<RegularizesAsAnnounced>);
struct AnnouncesEvaluate : GoodBxDF {
    static constexpr BxDFTraits kTraits{.evaluatesTogether = true};
    BSDFEval Evaluate(Vector3f, Vector3f) const { return {}; }  // without the mode
};
static_assert(!BxDFType<AnnouncesEvaluate>);
struct AnnouncesPacket : GoodBxDF {
    static constexpr BxDFTraits kTraits{.hasPacket = true};
};
static_assert(!BxDFType<AnnouncesPacket>);

struct GoodMaterial {
    static constexpr std::string_view kName = "good";
    static constexpr std::array<std::string_view, 1> kExamples{""};
    static constexpr MaterialTraits kTraits{};
    static GoodMaterial Create(ParamDict &, const NamedTextures &) { return {}; }
    GoodBxDF GetBxDF(const TextureEvalContext &, const SampledWavelengths &) const { return {}; }
};
static_assert(MaterialType<GoodMaterial>);

template <typename Base>
struct Derived : Base {
    static Derived Create(ParamDict &, const NamedTextures &) { return {}; }
};
static_assert(MaterialType<Derived<GoodMaterial>>);

struct WritesWavelengths : Derived<GoodMaterial> {
    static WritesWavelengths Create(ParamDict &, const NamedTextures &) { return {}; }
    GoodBxDF GetBxDF(const TextureEvalContext &, SampledWavelengths &) const { return {}; }
};
static_assert(!MaterialType<WritesWavelengths>);
struct WritesAsAnnounced : WritesWavelengths {
    static constexpr MaterialTraits kTraits{.terminatesWavelengths = true};
    static WritesAsAnnounced Create(ParamDict &, const NamedTextures &) { return {}; }
};
static_assert(MaterialType<WritesAsAnnounced>);
struct AnnouncesUniform : GoodMaterial {
    static constexpr MaterialTraits kTraits{.canBeUniform = true};
    static AnnouncesUniform Create(ParamDict &, const NamedTextures &) { return {}; }
    bool IsUnifrom() const { return true; }
};
static_assert(!MaterialType<AnnouncesUniform>);
struct HidesNullTransmission : GoodMaterial {
    static HidesNullTransmission Create(ParamDict &, const NamedTextures &) { return {}; }
    float NullTransmission(const TextureEvalContext &, Vector3f) const { return 0; }
};
static_assert(!MaterialType<HidesNullTransmission>);
struct HasNoExamples : GoodMaterial {
    static constexpr std::array<std::string_view, 0> kExamples{};
    static HasNoExamples Create(ParamDict &, const NamedTextures &) { return {}; }
};
static_assert(!MaterialType<HasNoExamples>);

struct GoodSampler {
    static constexpr std::string_view kName = "good";
    static constexpr std::array<std::string_view, 1> kExamples{""};
    static constexpr SamplerTraits kTraits{};
    static GoodSampler Create(ParamDict &, const SamplerContext &) { return {}; }
    int SamplesPerPixel() const { return 1; }
    void StartPixelSample(Point2i, int, int = 0) {}
    float Get1D() { return 0; }
    Point2f Get2D() { return {}; }
};
static_assert(SamplerType<GoodSampler>);
struct AnnouncesBatches : GoodSampler {
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static AnnouncesBatches Create(ParamDict &, const SamplerContext &) { return {}; }
};
static_assert(!SamplerType<AnnouncesBatches>);

TEST(Contracts, AreCheckedWhereThisFileIsCompiled) {}

}  // namespace
}  // namespace pbrt
