#include "pbrt/filters/filters.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pbrt/scene/description.h"

namespace pbrt {
namespace {

/// With the parameters of a directive that is read without a message.
template <typename F>
F Made(std::string_view parameters) {
    Diagnostics log;
    SceneDescription scene;
    const std::string text = fmt::format("PixelFilter \"{}\" {} WorldBegin", F::kName, parameters);
    ParseString(text, "test.pbrt", "", scene, log);
    ParamDict params(scene.filter.params, {}, "filter", nullptr, &log);
    const std::optional<Filter> filter = CreateFilter(params, F::kName);
    EXPECT_TRUE(log.Messages().empty()) << text;
    return std::get<F>(*filter);
}

/// The type's examples, and at other radii.
template <typename F>
std::vector<F> CasesOf() {
    std::vector<F> filters;
    for (const std::string_view example : F::kExamples)
        filters.push_back(Made<F>(example));
    if constexpr (std::is_constructible_v<F, Vector2f>)
        for (Vector2f radius : {Vector2f{1, 1}, {0.5f, 3}, {2.5f, 0.75f}, {8, 8}})
            filters.push_back(F(radius));
    return filters;
}

template <typename F>
class EveryFilter : public testing::Test {};
template <typename List>
struct TypesOf;
template <typename... Fs>
struct TypesOf<TypeList<Fs...>> {
    using Types = testing::Types<Fs...>;
};
TYPED_TEST_SUITE(EveryFilter, TypesOf<FilterTypes>::Types);

TYPED_TEST(EveryFilter, IsEvenAndZeroBeyondItsRadius) {
    for (const TypeParam &f : CasesOf<TypeParam>()) {
        const Vector2f r = f.Radius();
        for (int i = 0; i < 40; ++i) {
            const float t = float(i) / 20 - 1;
            for (float side : {-1.f, 1.f}) {
                EXPECT_EQ(f.Evaluate({side * (r.x + 1e-3f), t * r.y}), 0);
                EXPECT_EQ(f.Evaluate({t * r.x, side * (r.y + 1e-3f)}), 0);
                EXPECT_EQ(f.Evaluate({t * r.x, 0.3f * r.y}),
                          f.Evaluate({-t * r.x, side * 0.3f * r.y}));
            }
        }
    }
}

TYPED_TEST(EveryFilter, IntegralIsTheMidpointSums) {
    for (const TypeParam &f : CasesOf<TypeParam>()) {
        const Vector2f r = f.Radius();
        const int n = 512;
        double sum = 0;
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i)
                sum += f.Evaluate({r.x * (2 * (i + 0.5f) / n - 1), r.y * (2 * (j + 0.5f) / n - 1)});
        }
        const double integral = sum * 4 * r.x * r.y / (n * n);
        EXPECT_NEAR(f.Integral(), integral, 2e-4 * std::abs(integral));
    }
}

/// Each axis: the share of samples up to x, weighted, is the integral of f up to x.
TYPED_TEST(EveryFilter, SamplesFollowTheFilter) {
    for (const TypeParam &f : CasesOf<TypeParam>()) {
        const float r = f.Radius().x, peak = f.Evaluate({0, 0});
        const int n = 1 << 16, bins = 32;
        std::array<double, bins> sampled{}, exact{};
        float last = -r;
        for (int i = 0; i < n; ++i) {
            const FilterSample s = f.Sample({(float(i) + 0.5f) / n, 0.5f});
            ASSERT_LE(std::abs(s.p.x), r);
            EXPECT_GE(s.p.x, last) << "not monotonic";
            EXPECT_NEAR(s.p.y, 0, 1e-6);
            last = s.p.x;
            sampled[std::min(size_t((s.p.x / r + 1) / 2 * bins), size_t(bins - 1))] += s.weight / n;
        }
        // Both in units of the total along x, so that the integral over y drops out.
        double sumSampled = 0, sumExact = 0;
        for (int i = 0; i < n; ++i) {
            const float x = r * (2 * (float(i) + 0.5f) / n - 1);
            exact[size_t(i) * bins / n] += f.Evaluate({x, 0}) / peak * 2 * r / n;
        }
        for (int b = 0; b < bins; ++b)
            sumSampled += sampled[size_t(b)], sumExact += exact[size_t(b)];
        // 3e-4 of the peak, over a bin; and a sample's worth at each edge and change of sign.
        const double tolerance = 3e-4 * 2 * r / bins / std::abs(sumExact) + 4.0 / n;
        for (int b = 0; b < bins; ++b) {
            EXPECT_NEAR(sampled[size_t(b)] / sumSampled, exact[size_t(b)] / sumExact, tolerance)
                << f.kName << " bin " << b;
        }
    }
}

TYPED_TEST(EveryFilter, WeightsHaveConstantMagnitudeAndTheMeanOfTheIntegral) {
    for (const TypeParam &f : CasesOf<TypeParam>()) {
        const int n = 1 << 14;
        const float magnitude = f.Sample({0.5f, 0.5f}).weight;
        double alongX = 0, alongY = 0;
        for (int i = 0; i < n; ++i) {
            const float u = (float(i) + 0.5f) / n;
            for (const bool isX : {false, true}) {
                const FilterSample s = f.Sample(isX ? Point2f{u, 0.5f} : Point2f{0.5f, u});
                EXPECT_FLOAT_EQ(std::abs(s.weight), magnitude);
                const float value = f.Evaluate({s.p.x, s.p.y});
                if (std::abs(value) > 1e-3f * f.Evaluate({0, 0})) {
                    EXPECT_GT(value * s.weight, 0);
                }
                (isX ? alongX : alongY) += s.weight / magnitude / n;
            }
        }
        EXPECT_NEAR(magnitude * alongX * alongY, f.Integral(), 2e-3 * magnitude);
    }
}

TYPED_TEST(EveryFilter, ExtremeNumbersGiveFiniteOffsetsInside) {
    for (const TypeParam &f : CasesOf<TypeParam>()) {
        for (float u : {0.f, 0x1p-24f, 0.5f - 0x1p-25f, 0.5f, 0.5f + 0x1p-24f, OneMinusEpsilon}) {
            const FilterSample s = f.Sample({u, u});
            EXPECT_LE(std::abs(s.p.x), f.Radius().x);
            EXPECT_LE(std::abs(s.p.y), f.Radius().y);
            EXPECT_TRUE(std::isfinite(s.weight));
        }
    }
}

TEST(SincFilter, FallsMonotonicallyFromZero) {
    const SincProfile f(4, {});
    for (float x = 0, y; x < 1e-38f; x = y) {
        y = std::nextafter(x * 1.5f, 1.f);
        EXPECT_GE(f(x), f(y));
    }
    float x = 1e-6f;
    for (int i = 0; i < 10000; ++i) {
        const float y = std::nextafter(x, 1.f);
        EXPECT_GE(f(x), f(y));
        x = y;
    }
}

TEST(MitchellFilter, KnownValues) {
    const MitchellFilter f;
    EXPECT_FLOAT_EQ(f.Evaluate({0, 0}), Sqr(8.f / 9));  // 1 - B/3 at the centre
    EXPECT_FLOAT_EQ(f.Evaluate({1, 0}), 8.f / 9 / 18);  // B/6 at one pixel
    EXPECT_NEAR(f.Evaluate({2, 0}), 0, 1e-7);
}

struct Created {
    std::optional<Filter> filter;
    Diagnostics log;
};
Created Create(std::string_view type, std::string_view name = "", float value = 0) {
    ParsedParameters params;
    if (!name.empty()) {
        ParsedParameter p;
        p.type = "float", p.name = name, p.floats.assign(1, value);
        params.push_back(p);
    }
    Created c;
    ParamDict dict(params, {"scene.pbrt", 1, 1}, "filter", nullptr, &c.log);
    c.filter = CreateFilter(dict, type);
    return c;
}
Vector2f RadiusOf(const Created &c) {
    return std::visit([](const auto &f) { return f.Radius(); }, c.filter.value());
}

TEST(CreateFilter, PbrtsDefaultsAndParameters) {
    const std::vector<std::pair<const char *, float>> radii{
        {"box", 0.5f}, {"gaussian", 1.5f}, {"mitchell", 2.f}, {"sinc", 4.f}, {"triangle", 2.f}};
    for (const auto &[name, radius] : radii) {
        EXPECT_EQ(RadiusOf(Create(name)), (Vector2f{radius, radius}));
        EXPECT_EQ(RadiusOf(Create(name, "xradius", 3)), (Vector2f{3, radius}));
        EXPECT_FALSE(Create(name, "yradius", 3).log.HasErrors());
        EXPECT_TRUE(Create(name, "yradius", -1).log.HasErrors());
        EXPECT_TRUE(Create(name, "zradius", 1).log.HasErrors());
    }
    EXPECT_FALSE(Create("gaussian", "sigma", 0.7f).log.HasErrors());
    EXPECT_FALSE(Create("mitchell", "B", 0).log.HasErrors());
    EXPECT_FALSE(Create("mitchell", "C", 0.5f).log.HasErrors());
    EXPECT_FALSE(Create("sinc", "tau", 4).log.HasErrors());
    const Created unknown = Create("gausian");
    EXPECT_FALSE(unknown.filter);
    EXPECT_NE(unknown.log.Messages().at(0).text.find("did you mean \"gaussian\""),
              std::string::npos);
}

}  // namespace
}  // namespace pbrt
