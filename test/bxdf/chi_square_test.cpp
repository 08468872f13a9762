#include <numeric>

#include "bxdf/bxdf_types.h"
#include "support/chi_square.h"
#include "support/sphere_bins.h"

namespace pbrt::test {
namespace {

template <typename B>
class BxDFSampling : public testing::Test {};
TYPED_TEST_SUITE(BxDFSampling, BxDFTypes);

constexpr int kSamples = 1000000;

/// Samples per bin, and in the last place those that are of a delta lobe or none at all.
template <typename B>
std::vector<double> Sampled(const B &bxdf, Vector3f wo) {
    std::vector<double> counts(SphereBins::kCount + 1);
    Rng rng(12);
    for (int i = 0; i < kSamples; ++i) {
        const float uc = rng.Uniform();
        const auto s = bxdf.Sample_f(wo, uc, rng.Uniform2D(), TransportMode::Radiance);
        const bool counted = s && !IsSpecular(s->flags);
        ++counts[size_t(counted ? SphereBins::IndexOf(s->wi) : SphereBins::kCount)];
    }
    return counts;
}

/// Where lobes are sharpest: wo and its images in the planes of the frame.
std::vector<Vector3f> MirrorImages(Vector3f wo) {
    std::vector<Vector3f> images;
    for (int k = 0; k < 8; ++k)
        images.push_back({k & 1 ? -wo.x : wo.x, k & 2 ? -wo.y : wo.y, k & 4 ? -wo.z : wo.z});
    return images;
}

template <typename B>
std::vector<double> Expected(const B &bxdf, Vector3f wo) {
    const auto pdf = [&](Vector3f wi) { return double(bxdf.PDF(wo, wi, TransportMode::Radiance)); };
    std::vector<double> shares = SphereBins::Integrate(pdf, 1e-6, MirrorImages(wo));
    shares.push_back(1 - std::accumulate(shares.begin(), shares.end(), 0.0));
    for (double &s : shares)
        s *= kSamples;
    return shares;
}

/// Histogram of samples against the integrals of PDF, which so is normalised too: what is left of
/// it is the share of delta and missing samples. Significance 0.01 over all tests of a type.
TYPED_TEST(BxDFSampling, SamplesFollowThePDF) {
    const auto cases = CasesOf<TypeParam>();
    const std::vector<Vector3f> outgoing = Outgoing(5);
    const double significance = Sidak(0.01, int(cases.size() * outgoing.size()));
    for (const auto &c : cases) {
        // Lobes narrower than the bins: the law of agreement below covers them.
        if (c.sampleTolerance > 0.01f || !IsNonSpecular(c.bxdf.Flags())) continue;
        for (size_t i = 0; i < outgoing.size(); ++i) {
            const std::vector<double> counts = Sampled(c.bxdf, outgoing[i]);
            std::vector<double> expected = Expected(c.bxdf, outgoing[i]);
            // Quadrature's error, were it all in one bin.
            EXPECT_GT(expected.back(), -2e-4 * kSamples) << c << ": PDF integrates to more than 1";
            expected.back() = std::max(0.0, expected.back());
            const ChiSquare test = TestCounts(counts, expected);
            EXPECT_GT(test.pValue, significance)
                << c << ", wo " << i << ": chi-square " << test.statistic << " with "
                << test.degreesOfFreedom << " degrees of freedom";
            if (test.pValue > significance) continue;
            const std::string file = "chi_square_" + c.name + "_" + std::to_string(i) + ".exr";
            SphereBins::Dump(file, {"counts", "expected"}, {&counts, &expected});
            ADD_FAILURE() << "the tables are in " << file;
        }
    }
}

}  // namespace
}  // namespace pbrt::test
