// Sixteen feathers side by side against each by itself.

#include <gtest/gtest.h>

#include "feather/sixteen.h"

namespace pbrt::feather {
namespace {

/// Shapes that need every rule of RuleChoice, in all mixtures.
template <std::floating_point T>
Sixteen<T> AnySixteen(Dice &dice) {
    Sixteen<T> barbules;
    const double thickest = dice.Uniform() < 0.5 ? 700 : 1e4;
    const bool rough = dice.Uniform() < 0.5;
    for (int k = 0; k < kPacketSize; ++k) {
        Shape shape = dice.Uniform() < 0.3 ? Shape{} : dice.AnyShape();
        shape.thickness = dice.Uniform(0, thickest);
        if (rough && k % 3 != 0) shape.roughness = dice.Uniform(0, 40);
        barbules.Set(k, shape, Feather<T>({dice.Uniform(360, 830), 520, 590, 660}));
    }
    return barbules;
}

template <std::floating_point T>
Direction<SimdX16<T>> AnyDirections(Dice &dice) {
    Direction<SimdX16<T>> w;
    const bool above = dice.Uniform() < 0.7;
    for (int k = 0; k < kPacketSize; ++k)
        SetLane(&w, k, Rounded<T>(above ? dice.OnUpperHemisphere() : dice.OnSphere()));
    return w;
}

// In double nothing is rough: only the order of sums differs.
TEST(SixteenBarbules, InDoubleAreAsOneByOne) {
    using V = SimdX16<double>;
    Dice dice(90);
    for (int round = 0; round < 200; ++round) {
        const auto barbules = AnySixteen<double>(dice);
        const auto all = barbules.SideBySide();
        const auto wo = AnyDirections<double>(dice), wi = AnyDirections<double>(dice);
        const auto view = all.SeenFrom(wo);
        const auto f = all.f(view, wi), R = all.R(view, wi), TRT = all.TRT(view, wi);
        const V pdf = all.PDF(view, wi);
        for (int k = 0; k < kPacketSize; ++k) {
            const auto &one = barbules.One(k);
            const auto oneView = one.SeenFrom(Lane(wo, k));
            const auto in = Lane(wi, k);
            const auto expected = one.f(oneView, in), expectedR = one.R(oneView, in),
                       expectedTRT = one.TRT(oneView, in);
            for (int i = 0; i < 4; ++i) {
                EXPECT_NEAR(f[i][k], expected[i], 1e-10 * expected[i]);
                EXPECT_NEAR(R[i][k], expectedR[i], 1e-10 * expectedR[i]);
                EXPECT_NEAR(TRT[i][k], expectedTRT[i], 1e-10 * expectedTRT[i]);
            }
            EXPECT_NEAR(pdf[k], one.PDF(oneView, in), 1e-10 * pdf[k]);
            EXPECT_EQ(bool(BitsOf(view.grazing) >> k & 1), oneView.grazing);
        }
    }
}

TEST(SixteenBarbules, DrawAsOneByOne) {
    using V = SimdX16<double>;
    Dice dice(91);
    int gaps = 0;
    for (int round = 0; round < 500; ++round) {
        const auto barbules = AnySixteen<double>(dice);
        const auto all = barbules.SideBySide();
        const auto view = all.SeenFrom(AnyDirections<double>(dice));
        V uc, u0, u1;
        for (V *u : {&uc, &u0, &u1})
            for (int k = 0; k < kPacketSize; ++k)
                u->Set(k, dice.Uniform());
        const auto drawn = all.Draw(view, uc, u0, u1);
        for (int k = 0; k < kPacketSize; ++k) {
            const auto &one = barbules.One(k);
            const auto expected = one.Draw(one.SeenFrom(Lane(view.wo, k)), uc[k], u0[k], u1[k]);
            const bool isGap = BitsOf(drawn.isGap) >> k & 1;
            EXPECT_EQ(isGap, expected.isGap);
            gaps += isGap;
            EXPECT_NEAR(drawn.wi.x[k], expected.wi.x, 1e-10);
            EXPECT_NEAR(drawn.wi.y[k], expected.wi.y, 1e-10);
            EXPECT_NEAR(drawn.wi.z[k], expected.wi.z, 1e-10);
        }
    }
    EXPECT_GT(gaps, 100);
}

// TRT's inverses are good to 14 bits each, and its phase errs by 6e-8 of itself.
TEST(SixteenBarbules, InFloatAreNearlyAsOneByOne) {
    Dice dice(92);
    int others = 0, pairs = 0;
    for (int round = 0; round < 500; ++round) {
        const auto barbules = AnySixteen<float>(dice);
        const auto all = barbules.SideBySide();
        const auto wo = AnyDirections<float>(dice), wi = AnyDirections<float>(dice);
        const auto view = all.SeenFrom(wo);
        const auto TRT = all.TRT(view, wi), R = all.R(view, wi);
        const SimdX16<float> pdf = all.PDF(view, wi);
        for (int k = 0; k < kPacketSize; ++k, ++pairs) {
            const auto &one = barbules.One(k);
            const auto oneView = one.SeenFrom(Lane(wo, k));
            const auto expected = one.TRT(oneView, Lane(wi, k));
            const auto expectedR = one.R(oneView, Lane(wi, k));
            const float most = *std::max_element(expected.begin(), expected.end());
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(TRT[i][k], expected[i], 1e-3f * most + 1e-7f);
            // At the edge of what is seen the last bit decides.
            if ((R[0][k] > 0) != (expectedR[0] > 0)) {
                ++others;
                continue;
            }
            const float mostR = *std::max_element(expectedR.begin(), expectedR.end());
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(R[i][k], expectedR[i], 1e-4f * mostR);
            EXPECT_NEAR(pdf[k], one.PDF(oneView, Lane(wi, k)), 1e-4f * pdf[k]);
        }
    }
    EXPECT_LE(others, pairs / 1000);
}

// What is in the other lanes changes no more than the order of sums.
TEST(SixteenBarbules, DoNotDependOnTheirNeighbours) {
    Dice dice(93);
    for (int round = 0; round < 200; ++round) {
        const auto wo = AnyDirections<double>(dice), wi = AnyDirections<double>(dice);
        Dice a = dice, b = dice;
        b.Uniform();
        Sixteen<double> first = AnySixteen<double>(a), second = AnySixteen<double>(b);
        const int k = round % kPacketSize;
        const Shape same = dice.AnyShape();
        first.Set(k, same);
        second.Set(k, same);
        const auto one = first.SideBySide(), other = second.SideBySide();
        const auto f = one.f(one.SeenFrom(wo), wi), g = other.f(other.SeenFrom(wo), wi);
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(f[i][k], g[i][k], 1e-12 * f[i][k]);
    }
}

}  // namespace
}  // namespace pbrt::feather
