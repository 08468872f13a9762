// Every hard case of MODEL section 7: all must give finite values, none negative, in either scalar.

#include <gtest/gtest.h>

#include "feather/model.h"

namespace pbrt::feather {
namespace {

const std::vector<Direction<double>> &HardDirections() {
    static const std::vector<Direction<double>> directions = [] {
        std::vector<Direction<double>> d{
            {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {std::sqrt(.5), std::sqrt(.5), 0}};
        for (double theta : {89., 89.9, 89.99, 89.9999})
            for (double phi : {0., 45., 90., 180., 270.})
                d.push_back(Spherical(theta, phi));
        for (double tiny : {1e-4, 1e-7, 1e-11, 9e-13, 1e-20, 1e-38}) {
            d.push_back({1, 0, tiny});
            d.push_back({0, 1, tiny});
            d.push_back({0, -1, tiny});
        }
        for (double theta : {1e-5, 20., 60.})
            d.push_back(Spherical(theta, 37));
        const std::size_t above = d.size();
        for (std::size_t i = 0; i < above; ++i)
            d.push_back(-d[i]);
        return d;
    }();
    return directions;
}

const double kHalfPi = std::numbers::pi / 2;
const std::vector<double> kAspects{0.001, 1, 1000}, kSpacings{0.01, 2, 1e4};
const std::vector<double> kTilts{-kHalfPi, 0, kHalfPi}, kOpenings{0, 0.0785, 1.5};

/// Extremes of the film: thickness, and per wavelength index and melanin.
template <std::floating_point T>
std::vector<Barbule<T, 4>> Extremes(const Shape &shape) {
    std::vector<Barbule<T, 4>> barbules;
    constexpr double thicknesses[] = {0, 1, 590, 2e4, 1e6}, roughnesses[] = {0, 20, 0, 1e4, 3};
    for (int k = 0; k < 5; ++k) {
        Optics<T, 4> optics{{T(360), T(830), T(360), T(550)}, {}, {0, 1, 1, 0}};
        optics.eta = {T(1), T(1.0000002), T(1.5), T(3)};
        Shape s = shape;
        s.thickness = thicknesses[k];
        s.roughness = roughnesses[k];
        barbules.push_back(BarbuleOf<T>(s, optics));
    }
    return barbules;
}

template <std::floating_point T>
bool Sound(const std::array<T, 4> &f) {
    for (T v : f)
        if (!(v >= 0 && std::isfinite(v))) return false;
    return true;
}

template <class T>
class Corners : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Corners, Scalars);

TYPED_TEST(Corners, FAndPdfAreFinite) {
    using T = TypeParam;
    long wrong = 0, evaluated = 0;
    for (double aspect : kAspects)
        for (double spacing : kSpacings)
            for (double tilt : kTilts)
                for (double opening : kOpenings)
                    for (const auto &barbule : Extremes<T>({590, spacing, tilt, aspect, opening}))
                        for (std::size_t o = evaluated % 3; o < HardDirections().size(); o += 3) {
                            const auto view = barbule.SeenFrom(Rounded<T>(HardDirections()[o]));
                            const T gap = barbule.GapFraction(view.wo);
                            wrong += !(gap >= 0 && gap <= 1);
                            for (std::size_t i = o % 4; i < HardDirections().size(); i += 4) {
                                const auto wi = Rounded<T>(HardDirections()[i]);
                                const T pdf = barbule.PDF(view, wi);
                                wrong += !(pdf >= 0 && std::isfinite(pdf));
                                wrong += !Sound(barbule.f(view, wi));
                                ++evaluated;
                            }
                            wrong += !Sound(barbule.f(view, view.wo));
                            wrong += !Sound(barbule.f(view, -view.wo));
                        }
    EXPECT_EQ(wrong, 0) << "of " << evaluated;
    EXPECT_GT(evaluated, 10000);
}

TYPED_TEST(Corners, SamplesAreFinite) {
    using T = TypeParam;
    const T last = T(0x1.fffffep-1);  // 1 - 2^-24
    long wrong = 0, drawn = 0;
    for (double aspect : kAspects)
        for (double spacing : kSpacings)
            for (double tilt : kTilts)
                for (double opening : kOpenings)
                    for (const auto &barbule : Extremes<T>({590, spacing, tilt, aspect, opening}))
                        for (const Direction<double> &wo : HardDirections()) {
                            const auto view = barbule.SeenFrom(Rounded<T>(wo));
                            for (T uc : {T(0), T(0.5), last})
                                for (T u0 : {T(0), last})
                                    for (T u1 : {T(0), T(0.3), last}) {
                                        const auto s = barbule.SampleDirection(view, uc, u0, u1);
                                        if (!s) continue;
                                        ++drawn;
                                        wrong += !(s->pdf > 0 && std::isfinite(s->pdf));
                                        wrong += !Sound(s->f);
                                        wrong += !(std::abs(Dot(s->wi, s->wi) - 1) < 1e-4);
                                    }
                        }
    EXPECT_EQ(wrong, 0) << "of " << drawn;
    EXPECT_GT(drawn, 10000);
}

TYPED_TEST(Corners, BelowTheGuardNothingScatters) {
    using T = TypeParam;
    const auto barbule = BarbuleOf<T>({});
    for (T z : {T(0), T(1e-13), T(-1e-13)}) {
        const auto view = barbule.SeenFrom({1, 0, z});
        EXPECT_FALSE(barbule.Sample_f(view, T(.3), T(.3), T(.3)));
        EXPECT_EQ(barbule.PDF(view, {0, 0, 1}), 0);
        EXPECT_EQ(barbule.f(view, {0, 0, 1}), (std::array<T, 4>{}));
        const auto above = barbule.SeenFrom({0, 0, 1});
        EXPECT_EQ(barbule.PDF(above, {1, 0, z}), 0);
        EXPECT_EQ(barbule.f(above, {1, 0, z}), (std::array<T, 4>{}));
    }
}

TYPED_TEST(Corners, AStraightRowIsTheLeastOpening) {
    using T = TypeParam;
    const auto straight = BarbuleOf<T>({.opening = 0}), least = BarbuleOf<T>({.opening = 1e-3});
    const auto wo = Rounded<T>(Spherical(30, 20)), wi = Rounded<T>(Spherical(40, 200));
    EXPECT_EQ(straight.f(straight.SeenFrom(wo), wi), least.f(least.SeenFrom(wo), wi));
    EXPECT_EQ(straight.PDF(straight.SeenFrom(wo), wi), least.PDF(least.SeenFrom(wo), wi));
}

// Energy near grazing in float, where conservation is not asked for to the last digit.
TEST(CornersFloat, NoEnergyIsMadeNearGrazing) {
    auto optics = Feather<float>();
    optics.melanin.fill(1);
    Dice dice(40);
    for (double z : {1e-3, 1e-5, 1e-8, 1e-11})
        for (double phi : {0., 30., 85., 90.}) {
            const double p = phi * std::numbers::pi / 180;
            const auto barbule = BarbuleOf<float>(Shape{.spacing = 1.9, .opening = 0.3}, optics);
            const auto view = barbule.SeenFrom(Rounded<float>({std::cos(p), std::sin(p), z}));
            double light = 0;
            const int n = 20000;
            for (int i = 0; i < n; ++i) {
                const auto s =
                    barbule.Sample_f(view, float(dice.Uniform(0, .999999)),
                                     float(dice.Uniform(0, .999999)), float(dice.Uniform()));
                if (s) light += double(s->f[1]) * std::abs(s->wi.z) / s->pdf / n;
            }
            EXPECT_LE(light, 1.02) << "z " << z << " phi " << phi;
        }
}

}  // namespace
}  // namespace pbrt::feather
