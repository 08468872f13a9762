// The contracts of shapes and lights refuse types that are nearly right: a member that is announced
// and missing, misspelt or of another type, or that is there and not announced.

#include <gtest/gtest.h>

#include "pbrt/lights/lights.h"

namespace pbrt {
namespace {

static_assert(ShapeType<Disk>);
struct AnnouncesSixteen : Disk {
    static constexpr ShapeTraits kTraits{
        .canEmit = true, .intersectsItself = true, .hasObjectSpace = true, .fewestWide = 3};
    template <bool>
    bool IsWied() const {
        return true;
    }
};
static_assert(!ShapeType<AnnouncesSixteen>);
struct HidesThatItEmits : Disk {
    static constexpr ShapeTraits kTraits{.intersectsItself = true, .hasObjectSpace = true};
};
static_assert(!ShapeType<HidesThatItEmits>);
struct HidesItsSpace : Disk {
    static constexpr ShapeTraits kTraits{.canEmit = true, .intersectsItself = true};
};
static_assert(!ShapeType<HidesItsSpace>);
struct IntersectsInFloat : Disk {
    std::optional<float> Intersect(uint32_t, const RayD &) const { return {}; }
};
static_assert(!ShapeType<IntersectsInFloat>);
struct NeedsExamples : Disk {
    static constexpr std::array<std::string_view, 0> kExamples{};
};
static_assert(!ShapeType<NeedsExamples>);

static_assert(LightType<PointLight>);
struct AnnouncesLe : PointLight {
    static constexpr LightTraits kTraits{.isInfinite = true};
    SampledSpectrum Le(Vector3f, const SampledWavelengths &) const { return SampledSpectrum(0); }
};
static_assert(!LightType<AnnouncesLe>);  // no PDF_Li
struct HasLe : AnnouncesLe {
    float PDF_Li(Vector3f) const { return 0; }
};
static_assert(LightType<HasLe>);
struct HidesLe : HasLe {
    static constexpr LightTraits kTraits{.isDelta = true};
};
static_assert(!LightType<HidesLe>);
struct IsTwoThings : HasLe {
    static constexpr LightTraits kTraits{.isInfinite = true, .isDelta = true};
};
static_assert(!LightType<IsTwoThings>);
struct HidesPreprocess : PointLight {
    void Preprocess(float) {}
};
static_assert(!LightType<HidesPreprocess>);

TEST(Contracts, AreCheckedWhereThisFileIsCompiled) {}

}  // namespace
}  // namespace pbrt
