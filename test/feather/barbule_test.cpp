#include "pbrt/feather/barbule.h"

#include <gtest/gtest.h>

#include "feather/model.h"
#include "feather/trt_error.h"
#include "support/quadrature.h"

namespace pbrt::feather {
namespace {

/// Integrates over the sphere, bin by bin and adaptively in each.
template <class F>
double OverTheSphere(const F &f, double tolerance, int bins = 40) {
    const auto integrand = [&](double theta, double phi) {
        const double s = std::sin(theta);
        return s * f(Direction<double>{s * std::cos(phi), s * std::sin(phi), std::cos(theta)});
    };
    double sum = 0;
    const double side = std::numbers::pi / bins;
    for (int i = 0; i < bins; ++i)
        for (int j = 0; j < 2 * bins; ++j)
            sum += test::IntegrateAdaptively(integrand,
                                             {i * side, (i + 1) * side, j * side, (j + 1) * side},
                                             tolerance / bins, 4);
    return sum;
}

const std::vector<Direction<double>> kViews{
    Spherical(0, 0),   Spherical(25, 0),  Spherical(50, 180), Spherical(60, 35),
    Spherical(80, 90), Spherical(80, 20), -Spherical(40, 70)};

TEST(Barbule, IsReciprocal) {
    Dice dice(30);
    int lit = 0;
    for (int k = 0; k < 20000; ++k) {
        const auto barbule = BarbuleOf<double>(k % 2 ? dice.AnyShape() : Shape{});
        const Direction<double> wo = dice.OnSphere(), wi = dice.OnSphere();
        const auto there = barbule.f(barbule.SeenFrom(wo), wi);
        const auto back = barbule.f(barbule.SeenFrom(wi), wo);
        for (int i = 0; i < 4; ++i) {
            EXPECT_NEAR(there[i], back[i], 1e-9 * there[i]);
            lit += there[i] > 0;
        }
    }
    EXPECT_GT(lit, 10000);
}

// The row turned by pi about y is the same row, so above and below are not different. (Interleaved
// rules keep this within their error only: they give the two segments different points.)
TEST(Barbule, IsTheSameFromBelow) {
    Dice dice(31);
    for (int k = 0; k < 10000; ++k) {
        const auto barbule = BarbuleOf<double, FixedRule<4, 8, false>>(dice.AnyShape());
        const Direction<double> wo = dice.OnSphere(), wi = dice.OnSphere();
        const Direction<double> wo2{-wo.x, wo.y, -wo.z}, wi2{-wi.x, wi.y, -wi.z};
        const auto view = barbule.SeenFrom(wo), turned = barbule.SeenFrom(wo2);
        const auto a = barbule.f(view, wi), b = barbule.f(turned, wi2);
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(a[i], b[i], 1e-9 * a[i]);
        EXPECT_NEAR(barbule.PDF(view, wi), barbule.PDF(turned, wi2), 1e-9 * barbule.PDF(view, wi));
        EXPECT_NEAR(barbule.GapFraction(wo), barbule.GapFraction(wo2), 1e-12);
    }
}

TEST(Barbule, PdfIntegratesToOneMinusTheGap) {
    for (const Shape &shape : kShapes) {
        const auto barbule = BarbuleOf<double>(shape);
        for (const Direction<double> &wo : kViews) {
            const auto view = barbule.SeenFrom(wo);
            const double integral =
                OverTheSphere([&](Direction<double> wi) { return barbule.PDF(view, wi); }, 4e-3);
            const double gap = barbule.GapFraction(wo);
            EXPECT_NEAR(integral, 1 - (1 - view.pigmentChance) * gap, 3e-3)
                << shape << " wo " << wo.x << " " << wo.y << " " << wo.z;
        }
    }
}

/// Means over a regular grid of the sampler's numbers.
struct Returned {
    double light = 0;    ///< R + TRT + T by sampling, mean of the wavelengths
    double nothing = 0;  ///< share of draws without sample
};

template <class B>
Returned BySampling(const B &barbule, Direction<double> wo, int n) {
    const auto view = barbule.SeenFrom(wo);
    Returned mean;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            // uc runs through its interval in a low-discrepancy order
            const double uc = std::fmod((i * n + j) * 0.6180339887498949, 1);
            const auto s = barbule.Sample_f(view, uc, (i + 0.5) / n, (j + 0.5) / n);
            if (!s) {
                mean.nothing += 1.0 / (n * n);
                continue;
            }
            for (double f : s->f)
                mean.light += f * std::abs(s->wi.z) / s->pdf / (4.0 * n * n);
        }
    return mean;
}

TEST(Barbule, ReturnsNoMoreThanItReceives) {
    for (const Shape &shape : kShapes) {
        auto optics = Feather<double>();
        optics.melanin.fill(1);
        const auto barbule = BarbuleOf<double>(shape, optics);
        for (const Direction<double> &wo : kViews) {
            const Returned mean = BySampling(barbule, wo, 60);
            EXPECT_LE(mean.light, 1 + 0.01) << shape;
            EXPECT_LE(mean.nothing, 1e-3) << shape;
        }
    }
}

// Mean sample weight against the integral of f: one knows nothing of the other.
TEST(Barbule, SamplesWeighWhatFIntegratesTo) {
    for (const Shape &shape : {kShapes[0], kShapes[2], kShapes[7]}) {
        const auto barbule = BarbuleOf<double>(shape);
        for (const Direction<double> &wo : {kViews[3], kViews[6]}) {
            const auto view = barbule.SeenFrom(wo);
            const auto light = [&](Direction<double> wi) {
                double sum = 0;
                for (double f : barbule.f(view, wi))
                    sum += f / 4;
                return sum * std::abs(wi.z);
            };
            const double integral = OverTheSphere(light, 4e-3, 16) + barbule.GapFraction(wo);
            EXPECT_NEAR(BySampling(barbule, wo, 100).light / integral, 1, 0.01) << shape;
        }
    }
}

TEST(Barbule, ClosedRowsLetNothingThrough) {
    Dice dice(33);
    const auto barbule = BarbuleOf<float>(Shape{.aspect = 1});
    for (int k = 0; k < 10000; ++k) {
        const auto wo = Rounded<float>(dice.OnUpperHemisphere());
        const auto wi = Rounded<float>(-dice.OnUpperHemisphere());
        const auto view = barbule.SeenFrom(wo);
        EXPECT_EQ(barbule.f(view, wi), (std::array<float, 4>{}));
        EXPECT_EQ(barbule.GapFraction(wo), 0);
        // The mirror image of a low facet may lie below; its weight is then 0.
        const auto s = barbule.Sample_f(view, float(dice.Uniform()), float(dice.Uniform()),
                                        float(dice.Uniform()));
        if (s && s->wi.z < 0) {
            EXPECT_EQ(s->f, (std::array<float, 4>{}));
            EXPECT_FALSE(s->isGap);
        }
    }
}

TEST(Barbule, SampleAgreesWithFAndPdf) {
    Dice dice(34);
    for (int k = 0; k < 20000; ++k) {
        const auto barbule = BarbuleOf<float>(dice.AnyShape());
        const auto view = barbule.SeenFrom(Rounded<float>(dice.OnSphere()));
        const auto s = barbule.Sample_f(view, float(dice.Uniform()), float(dice.Uniform()),
                                        float(dice.Uniform()));
        if (!s || s->isGap) continue;
        EXPECT_EQ(s->pdf, barbule.PDF(view, s->wi));
        EXPECT_EQ(s->f, barbule.f(view, s->wi));
        EXPECT_NEAR(Dot(s->wi, s->wi), 1, 1e-5);
    }
}

template <std::floating_point T>
TRTError MeasurePigment(const Shape &shape, int pairs) {
    const auto fast = BarbuleOf<T>(shape);
    const auto exact = BarbuleOf<double, Converged<3, 4>>(shape);
    Dice dice(35);
    TRTErrorSum sum;
    for (int k = 0; k < pairs; ++k) {
        const Direction<double> wo = dice.OnUpperHemisphere(), wi = dice.OnUpperHemisphere();
        sum.Add(wo, wi, fast.TRT(fast.SeenFrom(Rounded<T>(wo)), Rounded<T>(wi)),
                exact.TRT(exact.SeenFrom(wo), wi));
    }
    return sum.Relative().value();
}

TEST(Barbule, PigmentIntegralIsAccurate) {
    const TRTError defaults = MeasurePigment<float>({}, 1500);
    EXPECT_LT(defaults.light, 0.003);
    EXPECT_LT(defaults.f, 0.006);
    for (const Shape &shape : kShapes) {
        EXPECT_LT(MeasurePigment<float>(shape, 200).light, 0.005) << shape;
        EXPECT_LT(MeasurePigment<double>(shape, 200).light, 0.005) << shape;
    }
    EXPECT_LT(MeasurePigment<float>({.thickness = 2000}, 200).light, 0.006);
}

// The definition as MODEL writes it against the rule that renders, which shares nothing with it.
TEST(Barbule, PlainDefinitionAgrees) {
    for (const Shape &shape : kShapes) {
        const auto plain = BarbuleOf<double, GaussPanel<24>>(shape);
        const auto fast = BarbuleOf<double, FixedRule<8, 24, false>>(shape);
        Dice dice(36);
        double off = 0, mean = 0;
        for (int k = 0; k < 500; ++k) {
            const Direction<double> wo = dice.OnSphere(), wi = dice.OnSphere();
            const auto a = plain.TRT(plain.SeenFrom(wo), wi), b = fast.TRT(fast.SeenFrom(wo), wi);
            off += std::pow((a[1] - b[1]) * wo.z * wi.z, 2) / 500;
            mean += a[1] * std::abs(wo.z * wi.z) / 500;
        }
        EXPECT_LT(std::sqrt(off) / mean, 0.02) << shape;
    }
}

}  // namespace
}  // namespace pbrt::feather
