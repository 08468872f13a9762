// Approximations against their stated errors.

#include "pbrt/simd/math.h"

#include <gtest/gtest.h>

#include "pbrt/simd/trig.h"
#include "simd/any.h"

namespace pbrt {
namespace {

/// Calls check(V, k) for vectors of numbers that next() gives.
template <class V, class Next, class Check>
void ForMany(Next next, Check check) {
    for (int round = 0; round < 5000; ++round) {
        V x;
        for (int k = 0; k < V::kSize; ++k)
            x.Set(k, next());
        check(x);
    }
}

template <class V>
class EveryFloats : public testing::Test {
  protected:
    std::mt19937 random{3};
    float Uniform(double a, double b) {
        return float(std::uniform_real_distribution<double>(a, b)(random));
    }
};
using Floats = testing::Types<FloatX4, Simd<float, 8>, FloatX16>;
TYPED_TEST_SUITE(EveryFloats, Floats);

TYPED_TEST(EveryFloats, Exp) {
    for (const float scale : {1.f, 87.f})
        ForMany<TypeParam>([&] { return this->Uniform(-scale, scale); },
                           [](const TypeParam &x) {
                               const TypeParam y = Exp(x);
                               for (int k = 0; k < TypeParam::kSize; ++k)
                                   ASSERT_NEAR(y[k] / std::exp(double(x[k])), 1, 2e-7) << x[k];
                           });
}
TYPED_TEST(EveryFloats, Log) {
    ForMany<TypeParam>([&] { return std::exp2(this->Uniform(-100, 100)); },
                       [](const TypeParam &x) {
                           const TypeParam y = Log(x);
                           for (int k = 0; k < TypeParam::kSize; ++k) {
                               const double exact = std::log(double(x[k]));
                               ASSERT_NEAR(y[k], exact, 1.5e-7 + 1.2e-7 * std::abs(exact)) << x[k];
                           }
                       });
}
TYPED_TEST(EveryFloats, Reciprocals) {
    ForMany<TypeParam>([&] { return std::exp2(this->Uniform(-122, 122)); },
                       [](const TypeParam &x) {
                           const TypeParam inverse = RcpApprox(x), root = RsqrtApprox(x);
                           for (int k = 0; k < TypeParam::kSize; ++k) {
                               ASSERT_NEAR(double(inverse[k]) * double(x[k]), 1, 0x1p-14);
                               ASSERT_NEAR(double(root[k]) * std::sqrt(double(x[k])), 1, 0x1p-14);
                           }
                       });
}
TYPED_TEST(EveryFloats, Sines) {
    ForMany<TypeParam>([&] { return this->Uniform(-0.5, 0.5); },
                       [](const TypeParam &x) {
                           const SinCosT<TypeParam> y = SinCosQuarters(x);
                           for (int k = 0; k < TypeParam::kSize; ++k) {
                               ASSERT_NEAR(y.sin[k], std::sin(double(x[k]) * M_PI / 2), 1.5e-7);
                               ASSERT_NEAR(y.cos[k], std::cos(double(x[k]) * M_PI / 2), 1.5e-7);
                           }
                       });
    for (const double range : {1., 30., 1048576.})
        ForMany<TypeParam>(
            [&] { return this->Uniform(-range, range); },
            [](const TypeParam &x) {
                const SinCosT<TypeParam> y = SinCosTurns(x);
                const TypeParam square = SinSquaredPi(x);
                const TypeParam rough = SinSquaredPiApprox<float>(3)(x);
                for (int k = 0; k < TypeParam::kSize; ++k) {
                    const double turns = std::remainder(double(x[k]), 1);
                    const double s = std::sin(M_PI * turns), exact = s * s;
                    ASSERT_NEAR(y.sin[k], std::sin(2 * M_PI * turns), 1.5e-7) << x[k];
                    ASSERT_NEAR(y.cos[k], std::cos(2 * M_PI * turns), 1.5e-7) << x[k];
                    // 2e-7, and twice the argument's rounding.
                    ASSERT_NEAR(square[k], exact, 3.2e-7 * exact) << x[k];
                    ASSERT_NEAR(rough[k], 3 * exact, 3 * 4.1e-5) << x[k];
                    ASSERT_GE(rough[k], 0);
                }
            });
}

TEST(SimdMath, OneNumberIsAsSeveral) {
    std::mt19937 random(4);
    for (int i = 0; i < 10000; ++i) {
        const float x = float(std::uniform_real_distribution<double>(-9, 9)(random));
        // The compiler may contract either in another way.
        EXPECT_NEAR(SinCosTurns(x).sin, SinCosTurns(FloatX16(x)).sin[7], 3e-7);
        EXPECT_NEAR(SinCosTurns(x).cos, SinCosTurns(FloatX16(x)).cos[7], 3e-7);
        EXPECT_NEAR(SinSquaredPi(x), SinSquaredPi(FloatX16(x))[7], 3e-7);
        EXPECT_NEAR(SinSquaredPiApprox(2.f)(x), SinSquaredPiApprox(FloatX16(2))(FloatX16(x))[7],
                    1e-6);
    }
}

TEST(SimdMath, DoubleIsTheStandardLibrarys) {
    for (double x = -3; x < 3; x += 0.01) {
        EXPECT_NEAR(SinCosTurns(x).sin, std::sin(2 * M_PI * x), 1e-14);
        EXPECT_NEAR(SinCosTurns(DoubleX4(x)).cos[1], std::cos(2 * M_PI * x), 1e-14);
        EXPECT_NEAR(SinSquaredPi(DoubleX16(x))[9], std::pow(std::sin(M_PI * x), 2), 1e-14);
        EXPECT_NEAR(RcpApprox(DoubleX16(x + 9.))[3] * (x + 9), 1, 1e-15);
    }
}

TEST(SimdMath, ExpAtTheEnds) {
    const float infinity = std::numeric_limits<float>::infinity();
    const FloatX4 y = Exp(FloatX4{0, -1e30f, 1e30f, -infinity});
    EXPECT_EQ(y[0], 1);
    EXPECT_TRUE(y[1] >= 0 && y[1] < 2e-38f);
    EXPECT_TRUE(y[2] > 1e38f && std::isfinite(y[2]));
    EXPECT_TRUE(y[3] >= 0 && y[3] < 2e-38f);
}

}  // namespace
}  // namespace pbrt
