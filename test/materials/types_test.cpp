// The lists of materials and of tested BxDFs belong together.

#include "bxdf/bxdf_types.h"
#include "pbrt/materials/materials.h"

namespace pbrt {
namespace {

template <typename B, typename... Tested>
constexpr bool IsOneOf(testing::Types<Tested...>) {
    return (std::is_same_v<B, Tested> || ...);
}

template <typename M>
using BxDFOf = decltype(std::declval<const M &>().GetBxDF(
    std::declval<const TextureEvalContext &>(), std::declval<SampledWavelengths &>()));

template <typename... Ms>
constexpr bool AllAreTested(TypeList<Ms...>) {
    return (IsOneOf<BxDFOf<Ms>>(test::BxDFTypes()) && ...);
}

static_assert(AllAreTested(MaterialTypes()),
              "the BxDF of a material is missing in BxDFTypes of test/bxdf/bxdf_types.h");

TEST(Materials, HaveDifferentNames) {
    std::vector<std::string_view> names = MaterialNames();
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace pbrt
