// What the published code gets wrong (the project's list of anchors), judged by the tracer. Rows
// that need no tracer are elsewhere: integral of the pdf, chi-square, reciprocity and NaN in
// test/feather and test/bxdf, float against double of the film in complex_airy_test.cpp.

#include <gtest/gtest.h>

#include "oracle/model_side.h"
#include "oracle/row_tracer.h"

namespace pbrt::oracle {
namespace {

using feather::Shape;

const DirectionBins kOneBin({}, 1, 1);

// White furnace, film = 1, one bounce. The figures are a straight row's; .5257 is .0002 too high
// for that (.52552, by a deterministic count) and .0003 for the bent one.
TEST(Anchors, WhiteFurnaceOfOneBounce) {
    struct Row {
        Shape shape;
        double theta, gap, reflected, tolerance;
    };
    const Row table[] = {{{}, 0, 0, .8760, 1e-4},
                         {{}, 60, .0375, .5257, 4e-4},
                         {{.spacing = 0.5}, 0, 0, 1.000, 5e-4},
                         {{.spacing = 0.5}, 60, 0, .938, 5e-4}};
    const PerfectMirror mirror;
    std::uint64_t seed = 7000;
    for (const Row &r : table)
        for (const double side : {1, -1}) {
            const Vec3 w = side * Towards(r.theta, 0);
            // A film a quarter of a wave thick leaves no angle without reflection to divide by.
            Shape shape = r.shape;
            shape.thickness = ModelSide::kLambda / (4 * ModelSide::kEta);
            const ModelSide model(shape, 0);
            const Estimate closed = model.IntegrateR(w, kOneBin, ++seed, 1024).mirrored;
            const RowLight light =
                RowTracer(BentRowOf(shape), mirror, kOneBin, kOneBin).Trace(w, {++seed, 1024});
            ExpectSame(closed, light.single, "mirrored");
            EXPECT_NEAR(light.single.mean, r.reflected,
                        r.tolerance + CriticalSigmas() * light.single.error);
            EXPECT_NEAR(light.gap.mean, r.gap, 1e-4 + CriticalSigmas() * light.gap.error);
            EXPECT_NEAR(model.Gap(w), r.gap, 1e-4);
        }
}

// True film over melanin that reflects everything, along the barbule: R + TRT + T of the published
// code is 1.29 at 80 degrees.
TEST(Anchors, GivesNoMoreThanItGetsAlongTheBarbule) {
    for (const double thickness : {580, 650})
        for (const double theta : {60, 80, 87}) {
            const Shape shape{.thickness = thickness};
            const ModelSide reflecting(shape, 0), scattering(shape, 1);
            const Vec3 w = Towards(theta, 90);
            const Estimate gap{reflecting.Gap(w), 0};
            const Estimate r = reflecting.IntegrateR(w, kOneBin, 7100, 1024).all;
            const Estimate trt = scattering.IntegrateTRT(w, kOneBin, 7101, 64).all;
            const Estimate all = r + trt + gap;
            EXPECT_LE(all.mean + CriticalSigmas() * all.error, 1);
            const FilmOverMelanin optics{{ModelSide::kLambda, thickness, ModelSide::kEta}, 1};
            const RowLight light =
                RowTracer(BentRowOf(shape), optics, kOneBin, kOneBin).Trace(w, {7102, 1024});
            ExpectSame(all, light.gap + light.single + light.pigment, "R + TRT + T");
        }
}

/// What the renderer's float sampler returns, per unit of light from w.
struct Drawn {
    Estimate scattered;  ///< mean weight of R and TRT
    Estimate passed;     ///< mean weight of the gap
};

using Sampled = feather::Barbule<float, 4>;

Drawn Draw(const Sampled &barbule, Vec3 w, std::uint64_t seed, int samples) {
    const auto view = barbule.SeenFrom({float(w.x), float(w.y), float(w.z)});
    std::mt19937_64 random(seed);
    Replicates tally(2);
    for (int replicate = 0; replicate < kReplicates; ++replicate) {
        EvenPoints<3> points(random);
        for (int i = 0; i < samples; ++i) {
            const auto [uc, u0, u1] = points.Next();
            const float below = std::nextafter(1.f, 0.f);
            const auto s = barbule.Sample_f(view, std::min(float(uc), below),
                                            std::min(float(u0), below), std::min(float(u1), below));
            if (!s) continue;
            const double weight = double(s->f[0]) * std::abs(s->wi.z) / s->pdf;
            tally.Add(s->isGap ? 1 : 0, weight);
            EXPECT_TRUE(std::isfinite(weight) && weight >= 0);
        }
        tally.Close(samples);
    }
    return {tally[0], tally[1]};
}

// The published code's mean sample weight is 1.15 to 3.3 times what its eval integrates to, and
// light from below leaks through. Here sampler, weights and gap, in float and with the default
// quadrature, return what the tracer returns; the quadrature may be off by half a percent of TRT.
TEST(Anchors, SamplesReturnWhatIsTraced) {
    std::uint64_t seed = 7200;
    for (const Shape &shape : {Shape{}, Shape{.spacing = 2.5}, Shape{.spacing = 0.3},
                               Shape{.tilt = -0.8}, Shape{.aspect = 1}, Shape{.opening = 0.9}})
        for (const auto &[theta, phi] : {std::pair{0, 0}, {40, 30}, {60, 180}, {80, 80}})
            for (const double side : {1, -1}) {
                const Vec3 w = side * Towards(theta, phi);
                feather::Optics<float, 4> optics;
                optics.lambda.fill(float(ModelSide::kLambda));
                optics.eta.fill(float(ModelSide::kEta));
                optics.melanin.fill(0.5f);
                const Sampled barbule(feather::ParamsOf<float>(shape), optics);
                const Drawn drawn = Draw(barbule, w, ++seed, 512);
                const FilmOverMelanin film{{ModelSide::kLambda, shape.thickness, ModelSide::kEta},
                                           0.5};
                const RowLight light =
                    RowTracer(BentRowOf(shape), film, kOneBin, kOneBin).Trace(w, {++seed, 512});
                const Estimate scattered = light.single + light.pigment;
                EXPECT_NEAR(
                    drawn.scattered.mean, scattered.mean,
                    0.005 * light.pigment.mean +
                        CriticalSigmas() * std::hypot(scattered.error, drawn.scattered.error))
                    << shape << " theta " << theta << " phi " << phi << " side " << side;
                ExpectSame(drawn.passed, light.gap, "gap");
            }
}

// eval up to 63 where pdf = 0: no f without a pdf to draw it, on either side.
TEST(Anchors, WhatScattersCanBeDrawn) {
    feather::Dice dice(50);
    for (int k = 0; k < 100000; ++k) {
        const Sampled barbule(feather::ParamsOf<float>(dice.AnyShape()), feather::Feather<float>());
        const auto wo = feather::Rounded<float>(dice.OnSphere());
        const auto wi = feather::Rounded<float>(dice.OnSphere());
        const auto view = barbule.SeenFrom(wo);
        const auto f = barbule.f(view, wi);
        if (*std::max_element(f.begin(), f.end()) > 0) {
            EXPECT_GT(barbule.PDF(view, wi), 0);
        }
    }
}

// eval is NaN at exactly +y in the published code.
TEST(Anchors, AlongTheBarbuleAllIsFinite) {
    for (const Shape &shape : feather::kShapes) {
        const Sampled barbule(feather::ParamsOf<float>(shape), feather::Feather<float>());
        for (const feather::Direction<float> wo :
             {feather::Direction<float>{0, 1, 0}, {0, -1, 0}}) {
            const auto view = barbule.SeenFrom(wo);
            for (const feather::Direction<float> wi :
                 {feather::Direction<float>{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0.6f, 0, -0.8f}}) {
                for (const float x : barbule.f(view, wi))
                    EXPECT_TRUE(std::isfinite(x) && x >= 0);
                EXPECT_TRUE(std::isfinite(barbule.PDF(view, wi)));
            }
            EXPECT_FALSE(barbule.Sample_f(view, 0.3f, 0.4f, 0.6f));
        }
    }
}

}  // namespace
}  // namespace pbrt::oracle
