// The suites of pbrt-v4's Hair tests (PBRT_FORMAT 5.1) for the feather. What is white here is a
// film that reflects everything: a single bounce and the gaps then return what ray tracing returns.

#include <gtest/gtest.h>

#include <numbers>

#include "bxdf/kronecker.h"
#include "feather/model.h"
#include "pbrt/bxdfs/feather_barbule_bxdf.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt {
namespace {

using feather::Shape;
using test::Kronecker;
constexpr TransportMode kMode = TransportMode::Radiance;

/// Reflects all but 1e-5 of light away from grazing incidence.
FeatherBarbuleBxDF Mirror(Shape shape) {
    feather::Optics<float, 4> optics = feather::Feather<float>();
    optics.eta.fill(999);
    optics.melanin.fill(0);
    shape.thickness = 0.1;
    return FeatherBarbuleBxDF(feather::BarbuleOf<float>(shape, optics));
}
FeatherBarbuleBxDF Keratin(const Shape &shape) {
    return FeatherBarbuleBxDF(feather::BarbuleOf<float>(shape));
}

/// Light from below comes out as from above, turned about y.
Vector3f Across(float degrees, bool below) {
    const Vector3f w{std::sin(Radians(degrees)), 0, std::cos(Radians(degrees))};
    return below ? -w : w;
}

/// MODEL section 8, by ray tracing of a straight row; ANCHORS for the spacing of 0.5.
struct Traced {
    Shape shape;
    float gamma;
    double gap, reflected;
};
const Traced kTraced[]{{{}, -75, 0, .9893},
                       {{}, 0, 0, .8760},
                       {{}, 60, .0375, .5255},
                       {{.spacing = 0.5}, 0, 0, 1},
                       {{.spacing = 0.5}, 60, 0, .938},
                       {{.tilt = -0.8}, 50, .3312, .3973},
                       {{.spacing = 2.5}, 0, .2454, .6673},
                       {{.aspect = 1}, 50, 0, .9129}};

/// Uniform directions. 3 %: the glint fills a tenth of the sphere.
TEST(FeatherBarbule, WhiteFurnace) {
    for (Traced t : kTraced) {
        t.shape.opening = 0.05;
        for (bool below : {false, true}) {
            const FeatherBarbuleBxDF feather = Mirror(t.shape);
            const Vector3f wo = Across(t.gamma, below);
            const int n = 200000;
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                const Vector3f wi = SampleUniformSphere({Kronecker(i)[0], Kronecker(i)[1]});
                sum += double(feather.f(wo, wi, kMode).Average()) * AbsCosTheta(wi);
            }
            EXPECT_NEAR(sum / n / UniformSpherePDF, t.reflected, 0.03 * t.reflected)
                << t.shape << " gamma " << t.gamma;
            EXPECT_NEAR(feather.GapFraction(wo), t.gap, 0.002) << t.shape << " gamma " << t.gamma;
        }
    }
}

TEST(FeatherBarbule, WhiteFurnaceSampled) {
    for (Traced t : kTraced) {
        t.shape.opening = 0.01;
        for (bool below : {false, true}) {
            const FeatherBarbuleBxDF feather = Mirror(t.shape);
            const Vector3f wo = Across(t.gamma, below);
            const int n = 20000;
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                const Kronecker u(i);
                const auto s = feather.Sample_f(wo, u[0], {u[1], u[2]}, kMode);
                if (s) sum += double(s->f.Average()) * AbsCosTheta(s->wi) / s->pdf;
            }
            EXPECT_NEAR(sum / n, t.gap + t.reflected, 0.003) << t.shape << " gamma " << t.gamma;
        }
    }
}

/// A mirror's samples are what is seen, in exact proportion: of weight 1, or 0 if on their way out
/// they meet a neighbour.
TEST(FeatherBarbule, SamplingWeights) {
    for (double spacing : {0.5, 1.25, 2.5}) {
        for (double tilt : {-0.8, -0.35, 0.3}) {
            for (double opening : {0.0785, 0.9}) {
                const FeatherBarbuleBxDF feather =
                    Mirror({.spacing = spacing, .tilt = tilt, .opening = opening});
                int whole = 0;
                for (int i = 0; i < 10000; ++i) {
                    const Kronecker u(i);
                    const Vector3f wo = SampleUniformSphere({u[0], u[1]});
                    const auto s = feather.Sample_f(wo, u[2], {u[3], u[4]}, kMode);
                    if (!s || std::abs(wo.z) < 0.02f || std::abs(s->wi.z) < 0.02f) continue;
                    // The film is no mirror where its facet is met at more than 84 degrees.
                    if (!IsSpecular(s->flags) && Length(wo + s->wi) < 0.2f) continue;
                    const float weight = s->f.Average() * AbsCosTheta(s->wi) / s->pdf;
                    whole += weight > 0;
                    EXPECT_NEAR(weight, weight > 0.5f ? 1 : 0, 0.01) << wo.z << " " << s->wi.z;
                }
                EXPECT_GT(whole, 4000);
            }
        }
    }
}

/// The same integral by sampling and by uniform directions, under light that is not uniform.
TEST(FeatherBarbule, SamplingConsistency) {
    Rng rng(6);
    const auto light = [](Vector3f w) { return Sqr(double(w.z)) + 0.2 * (1 + w.x); };
    for (double spacing : {0.6, 1.25, 2.5}) {
        for (double tilt : {-0.8, 0.3}) {
            for (double opening : {0.3, 0.9}) {
                const FeatherBarbuleBxDF feather =
                    Keratin({.spacing = spacing, .tilt = tilt, .opening = opening});
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
                double sampled = 0, uniform = 0;
                const int n = 65536, nUniform = 4 * n;  // few of these meet the glint
                for (int i = 0; i < n; ++i) {
                    const Kronecker u(i);
                    const auto s = feather.Sample_f(wo, u[0], {u[1], u[2]}, kMode);
                    if (s && !IsSpecular(s->flags))
                        sampled += s->f.Average() * AbsCosTheta(s->wi) / s->pdf * light(s->wi) / n;
                }
                for (int i = 0; i < nUniform; ++i) {
                    const Vector3f wi = SampleUniformSphere({Kronecker(i)[1], Kronecker(i)[2]});
                    uniform += feather.f(wo, wi, kMode).Average() * AbsCosTheta(wi) * light(wi) /
                               (UniformSpherePDF * nUniform);
                }
                EXPECT_NEAR(sampled / uniform, 1, 0.05) << spacing << " " << tilt << " " << opening;
            }
        }
    }
}

/// Directions along the barbules and in the vane's plane, barbules on end: nothing but finite.
TEST(FeatherBarbule, DirectionsOnTheEdge) {
    for (double tilt : {-std::numbers::pi / 2, 0.0, std::numbers::pi / 2}) {
        const FeatherBarbuleBxDF feather = Keratin({.tilt = tilt});
        Rng rng(7);
        for (int i = 0; i < 2000; ++i) {
            const Vector3f edges[]{{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {0, 1, 1e-7f}};
            const Vector3f wo = edges[i % 5], wi = SampleUniformSphere(rng.Uniform2D());
            EXPECT_TRUE(feather.f(wo, wi, kMode).IsFinite());
            EXPECT_TRUE(std::isfinite(feather.PDF(wo, wi, kMode)));
            const auto s = feather.Sample_f(wo, rng.Uniform(), rng.Uniform2D(), kMode);
            EXPECT_TRUE(!s || (s->f.IsFinite() && s->pdf > 0));
        }
    }
}

}  // namespace
}  // namespace pbrt
