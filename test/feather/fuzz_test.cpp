// Random directions and parameters, hard ones more often than chance would have them.

#include <gtest/gtest.h>

#include <cstring>

#include "feather/sixteen.h"

namespace pbrt::feather {
namespace {

using Model = Barbule<float, 4>;
constexpr unsigned kSeed = 20220801;
constexpr int kPairsPerModel = 10;

class Fuzz : public testing::Test {
  protected:
    /// In [lo, hi], both >= 0: at an end, or any power of ten alike.
    double AnyBetween(double lo, double hi) {
        const double u = dice.Uniform();
        if (u < 0.06) return u < 0.03 ? lo : hi;
        return dice.LogUniform(std::max(lo, 1e-3 * hi * 1e-6), hi);
    }
    Shape AnyLegalShape() {
        const double tilt = dice.Uniform() < 0.1 ? std::round(dice.Uniform(-1, 1)) * kHalfPi
                                                 : dice.Uniform(-kHalfPi, kHalfPi);
        if (dice.Uniform() < 0.3) return dice.AnyShape();
        return {AnyBetween(0, 1e6), AnyBetween(0.01, 1e4), tilt, AnyBetween(0.001, 1000),
                AnyBetween(0, 1.5)};
    }
    Optics<float, 4> AnyOptics() {
        Optics<float, 4> optics = Feather<float>();
        for (int i = 0; i < 4 && dice.Uniform() < 0.5; ++i) {
            optics.lambda[i] = float(dice.Uniform(360, 830));
            optics.eta[i] = float(1 + AnyBetween(0, 999));
            optics.melanin[i] = float(AnyBetween(0, 1));
        }
        return optics;
    }
    /// Unit to rounding; every other one with a component that is small by any power of ten.
    Direction<float> AnyDirection() {
        Direction<double> w = dice.OnSphere();
        if (dice.Uniform() < 0.5) {
            double *const components[]{&w.x, &w.y, &w.z, &w.z};
            *components[int(dice.Uniform(0, 3.999))] *= AnyBetween(1e-16, 1);
        }
        const double scale = 1 / std::sqrt(Dot(w, w));
        return Rounded<float>({w.x * scale, w.y * scale, w.z * scale});
    }
    float AnyNumber() {
        const double u = dice.Uniform();
        return u < 0.02 ? 0 : u > 0.98 ? 0x1.fffffep-1f : std::min(float(u), 0x1.fffffep-1f);
    }

    static bool Sound(float x) { return x >= 0 && x <= std::numeric_limits<float>::max(); }
    static bool Sound(const Model::Spectrum &f) {
        return Sound(f[0]) && Sound(f[1]) && Sound(f[2]) && Sound(f[3]);
    }
    static bool SameBits(const Model::Spectrum &a, const Model::Spectrum &b) {
        return std::memcmp(a.data(), b.data(), sizeof(a)) == 0;
    }

    /// One f, one PDF and one Sample_f; what is wrong with them, or nullptr.
    const char *Evaluate(const Model &model, const View<float> &view) {
        const Direction<float> wi = dice.Uniform() < 0.05   ? view.wo
                                    : dice.Uniform() < 0.05 ? -view.wo
                                                            : AnyDirection();
        const Model::Spectrum f = model.f(view, wi);
        const float pdf = model.PDF(view, wi);
        if (!Sound(f)) return "f";
        if (!Sound(pdf)) return "PDF";
        const auto s = model.Sample_f(view, AnyNumber(), AnyNumber(), AnyNumber());
        if (!s) return nullptr;
        if (!Sound(s->f) || !Sound(s->pdf) || s->pdf == 0) return "sample's f or PDF";
        if (std::abs(Dot(s->wi, s->wi) - 1) > 1e-4f || s->wi.z == 0) return "sample's direction";
        if (s->isGap) return nullptr;
        if (s->pdf != model.PDF(view, s->wi)) return "sample's PDF is not PDF of its direction";
        if (!SameBits(s->f, model.f(view, s->wi))) return "sample's f is not f of its direction";
        return nullptr;
    }
    void Run(int64_t evaluations) {
        int wrong = 0;
        for (int64_t k = 0; k < evaluations && wrong < 10; k += kPairsPerModel) {
            const Shape shape = AnyLegalShape();
            const Model model = BarbuleOf<float>(shape, AnyOptics());
            for (int i = 0; i < kPairsPerModel; ++i) {
                const View<float> view = model.SeenFrom(AnyDirection());
                const float gap = model.GapFraction(view.wo);
                const char *const what =
                    gap >= 0 && gap <= 1 ? Evaluate(model, view) : "gap fraction";
                wrong += what != nullptr;
                EXPECT_EQ(what, nullptr)
                    << what << ": evaluation " << k + i << ", " << shape << ", wo " << view.wo.x
                    << " " << view.wo.y << " " << view.wo.z;
            }
        }
    }

    /// f, PDF and a drawn direction of sixteen pairs.
    void RunSideBySide(int64_t evaluations) {
        using V = SimdX16<float>;
        int wrong = 0;
        for (int64_t n = 0; n < evaluations && wrong < 10; n += kPacketSize) {
            Sixteen<float> barbules;
            Direction<V> wo, wi;
            V u[3];
            for (int k = 0; k < kPacketSize; ++k) {
                barbules.Set(k, AnyLegalShape(), AnyOptics());
                SetLane(&wo, k, AnyDirection());
                SetLane(&wi, k,
                        dice.Uniform() < 0.05   ? Lane(wo, k)
                        : dice.Uniform() < 0.05 ? -Lane(wo, k)
                                                : AnyDirection());
                for (V &number : u)
                    number.Set(k, AnyNumber());
            }
            const auto all = barbules.SideBySide();
            const View<V> view = all.SeenFrom(wo);
            const auto f = all.f(view, wi);
            const V pdf = all.PDF(view, wi);
            const auto drawn = all.Draw(view, u[0], u[1], u[2]);
            const uint32_t grazing = BitsOf(view.grazing);
            for (int k = 0; k < kPacketSize; ++k) {
                const Direction<float> w = Lane(drawn.wi, k);
                const char *what = nullptr;
                if (!Sound({f[0][k], f[1][k], f[2][k], f[3][k]})) what = "f";
                if (!Sound(pdf[k])) what = "PDF";
                if (!(grazing >> k & 1) && !(std::abs(Dot(w, w) - 1) <= 1e-4f)) what = "direction";
                wrong += what != nullptr;
                EXPECT_EQ(what, nullptr) << what << ": evaluation " << n + k;
            }
        }
    }

    static constexpr double kHalfPi = std::numbers::pi / 2;
    Dice dice{kSeed};
};

TEST_F(Fuzz, AMillionEvaluations) {
    Run(1000000);
}
TEST_F(Fuzz, AMillionEvaluationsSideBySide) {
    RunSideBySide(1000000);
}
/// Some three minutes; --gtest_also_run_disabled_tests.
TEST_F(Fuzz, DISABLED_AHundredMillionEvaluations) {
    Run(100000000);
}
TEST_F(Fuzz, DISABLED_AHundredMillionEvaluationsSideBySide) {
    RunSideBySide(100000000);
}

}  // namespace
}  // namespace pbrt::feather
