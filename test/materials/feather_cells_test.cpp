// Cells of a feather's vane: their numbers, who finds them, what they do in the mean.

#include <fmt/format.h>

#include <cmath>

#include "feather/model.h"
#include "materials/material_text.h"
#include "pbrt/bxdfs/feather_barbule_packet.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"
#include "support/chi_square.h"
#include "support/sphere_bins.h"

namespace pbrt::test {
namespace {

constexpr auto kMode = TransportMode::Radiance;
const SampledWavelengths kLambda = SampledWavelengths::Of({450, 520, 590, 660});
const Frame kStraight{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

MaterialText Vane(const std::string &parameters) {
    return MaterialText("Material \"featherbarbule\" " + parameters);
}
const std::string kGrid = " \"float cellsacross\" 40 \"float cellsalong\" 25 ";
const std::string kVaried =
    " \"float cellthickness\" 10 \"float celltilt\" .05 \"float cellbend\" .03 ";

// Figures computed elsewhere from the text of MODEL section 11.
TEST(FeatherCells, Numbers) {
    struct Row {
        int64_t i, j;
        int face, seed;
        float n[3];
    };
    constexpr Row table[] = {{0, 0, 0, 0, {.128736f, -.581861f, -.772810f}},
                             {1, 0, 0, 0, {.312602f, .120913f, .924196f}},
                             {0, 1, 0, 0, {.568646f, -1.346187f, -.421305f}},
                             {-1, 7, 3, 9, {.979512f, -1.401847f, 1.014160f}},
                             {1359, 17, 0, 0, {.629909f, -.754574f, .266801f}}};
    for (const Row &row : table) {
        const FeatherCell cell = FeatherCells::Of(row.i, row.j, row.face, row.seed);
        EXPECT_NEAR(cell.thickness, row.n[0], 1e-6f);
        EXPECT_NEAR(cell.tilt, row.n[1], 1e-6f);
        EXPECT_NEAR(cell.bend, row.n[2], 1e-6f);
    }
}

// Five standard errors: of a mean 1/sqrt(n), of a variance 1.3/sqrt(n) (the fourth moment is 2.7).
TEST(FeatherCells, AreUnlikeTheirNeighbours) {
    constexpr int kSide = 320, kCells = kSide * kSide;
    const double five = 5 / std::sqrt(double(kCells));
    const auto numbers = [](int64_t i, int64_t j) {
        const FeatherCell c = FeatherCells::Of(i, j, 0, 0);
        return std::array<double, 3>{c.thickness, c.tilt, c.bend};
    };
    for (int a = 0; a < 3; ++a) {
        double mean = 0, square = 0;
        std::array<double, 3> right{}, up{}, self{};
        for (int k = 0; k < kCells; ++k) {
            const int64_t i = k % kSide - kSide / 2, j = k / kSide - kSide / 2;
            const double x = numbers(i, j)[size_t(a)];
            EXPECT_LT(std::abs(x), 3.4642);
            mean += x / kCells, square += x * x / kCells;
            for (size_t b = 0; b < 3; ++b) {
                right[b] += x * numbers(i + 1, j)[b] / kCells;
                up[b] += x * numbers(i, j + 1)[b] / kCells;
                if (int(b) != a) self[b] += x * numbers(i, j)[b] / kCells;
            }
        }
        EXPECT_NEAR(mean, 0, five);
        EXPECT_NEAR(square, 1, 1.3 * five);
        for (size_t b = 0; b < 3; ++b) {
            EXPECT_NEAR(right[b], 0, five);
            EXPECT_NEAR(up[b], 0, five);
            EXPECT_NEAR(self[b], 0, five);
        }
    }
}

FeatherCells Grid(const std::string &parameters) {
    SceneDescription scene;
    Diagnostics log;
    ParseString("WorldBegin\nMaterial \"featherbarbule\" " + parameters, "t.pbrt", "", scene, log);
    Entity entity;
    for (const Entity &e : scene.materials)
        entity = e;
    ParamDict params(entity.params, entity.loc, "material", entity.colorSpace, &log);
    return FeatherCells::Create(params);
}
bool Same(const FeatherCell &a, const FeatherCell &b) {
    return a.thickness == b.thickness && a.tilt == b.tilt && a.bend == b.bend;
}

TEST(FeatherCells, LieOnAGridOfUV) {
    const FeatherCells cells =
        Grid("\"float cellsacross\" 4 \"float cellsalong\" 8 \"float cellshear\" .5");
    const auto expectCell = [&](float u, float v, int64_t i, int64_t j) {
        EXPECT_TRUE(Same(cells.At(AtUV(u, v)), FeatherCells::Of(i, j, 0, 0))) << u << " " << v;
    };
    expectCell(0.1f, 0.01f, 0, 0);
    expectCell(0.25f, 0, 1, 0);  // an edge belongs to what lies beyond
    expectCell(std::nextafter(0.25f, 0.f), 0, 0, 0);
    expectCell(-1e-6f, 0, -1, 0);
    expectCell(-0.3f, -0.01f, -2, -1);
    expectCell(0.1f, 0.5f, 1, 4);  // u + v/2 = .35
    expectCell(20000.5f, 30000, 140002, 240000);
    expectCell(-0.f, -0.f, 0, 0);
}

TEST(FeatherCells, OfFarPlacesAndNone) {
    const FeatherCells cells = Grid("\"float cellsacross\" 1e6 \"float cellsalong\" 1e6");
    for (const float x : {1e30f, -1e30f, Infinity, -Infinity, std::nanf("")}) {
        const FeatherCell cell = cells.At(AtUV(x, x));
        EXPECT_TRUE(std::isfinite(cell.thickness) && Same(cell, cells.At(AtUV(x, x))));
    }
}

TEST(FeatherCells, OfFacesAndSeeds) {
    TextureEvalContext a = AtUV(0.5f, 0.5f), b = a;
    b.faceIndex = 7;
    const FeatherCells together = Grid(kGrid), apart = Grid(kGrid + "\"bool cellsperface\" true"),
                       other = Grid(kGrid + "\"integer cellseed\" 1");
    EXPECT_TRUE(Same(together.At(a), together.At(b)));
    EXPECT_TRUE(Same(together.At(a), apart.At(a)));
    EXPECT_FALSE(Same(apart.At(a), apart.At(b)));
    EXPECT_FALSE(Same(together.At(a), other.At(a)));
    EXPECT_FALSE(Grid("\"float cellsacross\" 5"));
    EXPECT_FALSE(Grid("\"float cellsalong\" 5"));
}

/// What a material says of a point, by all its members.
struct Said {
    SampledSpectrum f, wide;
    Frame frame;
    float gap, gapOfBxDF;
};
Said Ask(const FeatherBarbuleMaterial &material, const TextureEvalContext &ctx, Vector3f wo,
         Vector3f wi) {
    FeatherBarbulePacket packet;
    for (int i = 0; i < kPacketSize; ++i)
        packet.Set(i, material.GetPacketInput(ctx, kLambda));
    const FeatherBarbuleBxDF bxdf = material.GetBxDF(ctx, kLambda);
    const auto lanes =
        packet.f({Broadcast<16>(wo.x), Broadcast<16>(wo.y), Broadcast<16>(wo.z)},
                 {Broadcast<16>(wi.x), Broadcast<16>(wi.y), Broadcast<16>(wi.z)}, kAllLanes);
    return {bxdf.f(wo, wi, kMode), lanes[5], material.TurnFrame(kStraight, ctx),
            material.NullTransmission(ctx, wo), bxdf.GapFraction(wo)};
}

// One material with cells beside one whose constants are those of the cell.
TEST(FeatherCells, EveryoneFindsTheSame) {
    const auto made = Vane("\"float spacing\" 2.5 \"float rotation\" 30" + kGrid + kVaried);
    const auto &material = made.As<FeatherBarbuleMaterial>();
    EXPECT_FALSE(material.IsUniform());
    EXPECT_TRUE(material.TurnsFrame());
    Rng rng(1);
    for (int k = 0; k < 200; ++k) {
        const TextureEvalContext ctx = AtUV(4 * rng.Uniform() - 2, 4 * rng.Uniform() - 2);
        const FeatherCell cell = FeatherCells::Of(int64_t(std::floor(40 * ctx.uv.x)),
                                                  int64_t(std::floor(25 * ctx.uv.y)), 0, 0);
        const auto plain =
            Vane(fmt::format("\"float spacing\" 2.5 \"float thickness\" {:.9g} \"float tilt\" "
                             "{:.9g}",
                             590 + 10 * cell.thickness, -0.35f + 0.05f * cell.tilt));
        const Vector3f wo = SampleUniformSphere(rng.Uniform2D()),
                       wi = SampleUniformSphere(rng.Uniform2D());
        const Said found = Ask(material, ctx, wo, wi);
        const Said expected = Ask(plain.As<FeatherBarbuleMaterial>(), ctx, wo, wi);
        for (int i = 0; i < NSpectrumSamples; ++i) {
            EXPECT_NEAR(found.f[i], expected.f[i], 1e-4f * expected.f[i]);
            EXPECT_NEAR(found.wide[i], expected.wide[i], 1e-4f * expected.wide[i]);
        }
        EXPECT_NEAR(found.gap, expected.gap, 1e-5f);
        EXPECT_EQ(found.gap, found.gapOfBxDF);
        const float turn = Radians(30.f), bend = 0.03f * cell.bend;
        const Vector3f y{-std::sin(turn), std::cos(turn), 0};
        EXPECT_LT(Length(found.frame.x - Vector3f{std::cos(turn), std::sin(turn), 0}), 1e-6f);
        EXPECT_LT(Length(found.frame.y - (std::cos(bend) * y - std::sin(bend) * kStraight.z)),
                  1e-6f);
        EXPECT_LT(Length(found.frame.z - (std::sin(bend) * y + std::cos(bend) * kStraight.z)),
                  1e-6f);
    }
}

TEST(FeatherCells, DeviationsMayBeTextures) {
    const std::string ramp =
        "Texture \"t\" \"float\" \"checkerboard\" \"float tex1\" 0 \"float tex2\" .1\n";
    const MaterialText made(ramp + "Material \"featherbarbule\" \"texture celltilt\" \"t\" " +
                            kGrid);
    const auto &material = made.As<FeatherBarbuleMaterial>();
    const auto plain = Vane("");
    const Vector3f wo = Normalize(Vector3f{.1f, .2f, .9f}), wi = Normalize(Vector3f{-.2f, -.1f, 1});
    const auto f = [&](float u) { return Ask(material, AtUV(u, 0.5f), wo, wi).f[0]; };
    const float expected = Ask(plain.As<FeatherBarbuleMaterial>(), {}, wo, wi).f[0];
    EXPECT_NE(f(0.5f) == expected, f(1.5f) == expected);
}

TEST(FeatherCells, NeedAGrid) {
    for (const char *name : {"cellthickness", "celltilt", "cellbend"}) {
        const auto made = Vane(fmt::format("\"float {}\" .1 \"float cellsacross\" 5", name));
        EXPECT_EQ(made.Messages(),
                  fmt::format("t.pbrt:2:27: \"{}\" is how cells differ, and there are none: give "
                              "\"cellsacross\" and \"cellsalong\", the number of cells for one "
                              "unit of u and of v\n",
                              name));
    }
    EXPECT_EQ(Vane("\"float cellsacross\" 5").Messages(), "");
    // One cause, one message.
    EXPECT_EQ(Vane(kVaried).log.Messages().size(), 1u);
}

TEST(FeatherCells, OfNoDeviationChangeNothing) {
    const auto with = Vane(kGrid + "\"integer cellseed\" 3"), without = Vane("");
    Rng rng(2);
    for (int k = 0; k < 50; ++k) {
        const TextureEvalContext ctx = AtUV(rng.Uniform(), rng.Uniform());
        const Vector3f wo = SampleUniformSphere(rng.Uniform2D()),
                       wi = SampleUniformSphere(rng.Uniform2D());
        const Said a = Ask(with.As<FeatherBarbuleMaterial>(), ctx, wo, wi),
                   b = Ask(without.As<FeatherBarbuleMaterial>(), ctx, wo, wi);
        for (int i = 0; i < NSpectrumSamples; ++i)
            EXPECT_EQ(a.f[i], b.f[i]);
        EXPECT_EQ(a.gap, b.gap);
        EXPECT_EQ(a.frame.z, b.frame.z);
    }
}

/// Density of the sum of four uniform numbers, of variance 1: a cubic spline.
double BellDensity(double x) {
    const double t = std::abs(x) / std::numbers::sqrt3;
    const double spline = t < 1   ? (4 - 6 * t * t + 3 * t * t * t) / 6
                          : t < 2 ? std::pow(2 - t, 3) / 6
                                  : 0;
    return spline / std::numbers::sqrt3;
}

// The far lobe is the mean over cells: of 1e5 of them against a sum over the density of their
// numbers, made without cells.
TEST(FeatherCells, MeanIsThatOverTheBell) {
    const auto made = Vane(kGrid + kVaried);
    const auto &material = made.As<FeatherBarbuleMaterial>();
    const Vector3f wo = Normalize(Vector3f{-.25f, .1f, .9f}),
                   wi = Normalize(Vector3f{.1f, -.04f, 1});
    constexpr int kCells = 100000, kSteps = 48;
    std::array<double, 4> mean{}, square{}, expected{};
    for (int k = 0; k < kCells; ++k) {
        const auto ctx = AtUV((float(k % 400) + .5f) / 40, (float(k / 400) + .5f) / 25);
        const Frame frame = material.TurnFrame(kStraight, ctx);
        const auto f =
            material.GetBxDF(ctx, kLambda).f(frame.ToLocal(wo), frame.ToLocal(wi), kMode);
        for (int i = 0; i < 4; ++i) {
            mean[size_t(i)] += double(f[i]) / kCells;
            square[size_t(i)] += double(f[i]) * f[i] / kCells;
        }
    }
    const double most = 2 * std::numbers::sqrt3, step = 2 * most / kSteps;
    const auto number = [&](int k) { return -most + (k + 0.5) * step; };
    for (int a = 0; a < kSteps; ++a)
        for (int b = 0; b < kSteps; ++b) {
            const feather::Shape shape{.thickness = 590 + 10 * number(a),
                                       .tilt = -0.35 + 0.05 * number(b)};
            const auto barbule = feather::BarbuleOf<float>(shape);
            for (int c = 0; c < kSteps; ++c) {
                const float bend = float(0.03 * number(c));
                const auto local = [&](Vector3f w) {
                    return feather::Direction<float>{w.x,
                                                     std::cos(bend) * w.y - std::sin(bend) * w.z,
                                                     std::sin(bend) * w.y + std::cos(bend) * w.z};
                };
                const auto f = barbule.f(barbule.SeenFrom(local(wo)), local(wi));
                const double weight = BellDensity(number(a)) * BellDensity(number(b)) *
                                      BellDensity(number(c)) * step * step * step;
                for (size_t i = 0; i < 4; ++i)
                    expected[i] += weight * double(f[i]);
            }
        }
    for (size_t i = 0; i < 4; ++i) {
        const double error = std::sqrt((square[i] - mean[i] * mean[i]) / kCells);
        // f is cut off where a facet is hidden or off the arc: half a step of the bend there.
        EXPECT_NEAR(mean[i], expected[i], 5 * error + 0.01 * expected[i]);
        EXPECT_LT(error, 0.005 * expected[i]);
    }
}

// One cell, turned: what is drawn in its frame and counted in the world's follows its density.
TEST(FeatherCells, SamplesOfATurnedCell) {
    const auto made =
        Vane("\"float spacing\" 2.5 \"float celltilt\" .2 \"float cellbend\" .3" + kGrid);
    const auto &material = made.As<FeatherBarbuleMaterial>();
    const TextureEvalContext ctx = AtUV(0.01f, 0.01f);
    const Frame frame = material.TurnFrame(kStraight, ctx);
    EXPECT_LT(frame.z.z, 0.98f);
    const FeatherBarbuleBxDF bxdf = material.GetBxDF(ctx, kLambda);
    constexpr int kSamples = 1000000;
    Rng rng(3);
    const Vector3f wo = frame.ToLocal(Normalize(Vector3f{.4f, .3f, .7f}));
    std::vector<double> counts(SphereBins::kCount + 1);
    double passed = 0;
    for (int k = 0; k < kSamples; ++k) {
        const float uc = rng.Uniform();
        const auto s = bxdf.Sample_f(wo, uc, rng.Uniform2D(), kMode);
        const bool scattered = s && !IsSpecular(s->flags);
        ++counts[size_t(scattered ? SphereBins::IndexOf(frame.FromLocal(s->wi))
                                  : SphereBins::kCount)];
        if (s && !scattered) passed += s->f[0] * std::abs(s->wi.z) / s->pdf / kSamples;
    }
    std::vector<double> expected = SphereBins::Integrate(
        [&](Vector3f wi) { return double(bxdf.PDF(wo, frame.ToLocal(wi), kMode)); }, 1e-6);
    double sum = 0;
    for (const double share : expected)
        sum += share;
    expected.push_back(std::max(0.0, 1 - sum));
    for (double &share : expected)
        share *= kSamples;
    EXPECT_GT(TestCounts(counts, expected).pValue, 0.01);
    // Shadow rays: weights of the gap's samples are at most 1/(1 - p_t).
    EXPECT_NEAR(passed, material.NullTransmission(ctx, wo), 0.004);
}

}  // namespace
}  // namespace pbrt::test
