// Cells of a feather's vane: their numbers, and who finds them.

#include <fmt/format.h>

#include <cmath>

#include "materials/vane_text.h"
#include "pbrt/bxdfs/feather_barbule_packet.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt::test {
namespace {

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

/// The answers of a material at a point, by all its members.
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

}  // namespace
}  // namespace pbrt::test
