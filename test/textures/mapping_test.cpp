#include "pbrt/textures/mapping2d.h"

#include <random>

#include "textures/texture_scene.h"

namespace pbrt::test {
namespace {

TEST(UVMapping, ScalesAndShifts) {
    const UVMapping m{2, 3, 0.5f, -1};
    TextureEvalContext ctx = AtUV(0.25f, 0.5f);
    ctx.dudx = 0.1f, ctx.dudy = 0.2f, ctx.dvdx = 0.3f, ctx.dvdy = 0.4f;
    const TexCoord2D c = m.Map(ctx);
    EXPECT_FLOAT_EQ(c.st.x, 1);
    EXPECT_FLOAT_EQ(c.st.y, 0.5f);
    EXPECT_FLOAT_EQ(c.dsdx, 0.2f);
    EXPECT_FLOAT_EQ(c.dsdy, 0.4f);
    EXPECT_FLOAT_EQ(c.dtdx, 0.9f);
    EXPECT_FLOAT_EQ(c.dtdy, 1.2f);
}

TEST(SphericalMapping, GivesPolarAngleAndTurn) {
    const SphericalMapping m{Transform()};
    const auto st = [&](Point3f p) { return m.Map(AtPoint(p)).st; };
    EXPECT_NEAR(st({0, 0, 2}).x, 0, 1e-6);
    EXPECT_NEAR(st({0, 0, -2}).x, 1, 1e-6);
    EXPECT_NEAR(st({3, 0, 0}).x, 0.5, 1e-6);
    EXPECT_NEAR(st({0, 3, 0}).y, 0.25, 1e-6);
    EXPECT_NEAR(st({0, -3, 0}).y, 0.75, 1e-6);
}

TEST(CylindricalMapping, GivesTurnAndHeight) {
    const CylindricalMapping m{Transform::Translate({0, 0, -1})};
    const Point2f st = m.Map(AtPoint({0, 2, 1.25f})).st;
    EXPECT_NEAR(st.x, 0.75, 1e-6);
    EXPECT_NEAR(st.y, 0.25, 1e-6);
}

TEST(PlanarMapping, ProjectsOnItsAxes) {
    const PlanarMapping m{Transform(), {2, 0, 0}, {0, 0, 1}, 0.5f, 1};
    const Point2f st = m.Map(AtPoint({1, 7, 3})).st;
    EXPECT_FLOAT_EQ(st.x, 2.5f);
    EXPECT_FLOAT_EQ(st.y, 4);
}

/// Derivatives against differences of the coordinates over a step of the pixel.
template <typename Mapping>
void ExpectStepsMatchDifferences(const Mapping &mapping) {
    std::mt19937 rng(5);
    std::uniform_real_distribution<float> coordinate(0.5f, 1.5f);
    for (int i = 0; i < 50; ++i) {
        TextureEvalContext ctx = AtPoint({coordinate(rng), coordinate(rng), coordinate(rng)});
        constexpr float h = 1e-3f;
        ctx.dpdx = {h, -2 * h, h}, ctx.dpdy = {-h, h, 3 * h};
        const TexCoord2D c = mapping.Map(ctx);
        const auto difference = [&](Vector3f step) {
            const Point2f a = mapping.Map(AtPoint(ctx.p + 0.5f * step)).st;
            return a - mapping.Map(AtPoint(ctx.p - 0.5f * step)).st;
        };
        const Vector2f x = difference(ctx.dpdx), y = difference(ctx.dpdy);
        // Rounding of st, 6e-8, on steps of about 1e-3.
        EXPECT_NEAR(c.dsdx, x.x, 1e-6);
        EXPECT_NEAR(c.dtdx, x.y, 1e-6);
        EXPECT_NEAR(c.dsdy, y.x, 1e-6);
        EXPECT_NEAR(c.dtdy, y.y, 1e-6);
    }
}

TEST(Mappings, KnowTheirSteps) {
    const Transform t = *Transform::Rotate(20, {1, 2, 3});
    ExpectStepsMatchDifferences(SphericalMapping{t});
    ExpectStepsMatchDifferences(CylindricalMapping{t});
    ExpectStepsMatchDifferences(PlanarMapping{t, {1, 0.5f, 0}, {0, 1, -1}, 0, 0});
}

TEST(Mappings, UseTheTexturesTransform) {
    const TextureScene s(R"(
        Translate 10 0 0
        Texture "p" "float" "checkerboard" "string mapping" "planar"
        Texture "cube" "float" "checkerboard" "integer dimension" 3
    )");
    EXPECT_EQ(s.Float("p").Evaluate(AtPoint({10.5f, 0.5f, 0})), 1);
    EXPECT_EQ(s.Float("p").Evaluate(AtPoint({9.5f, 0.5f, 0})), 0);
    EXPECT_EQ(s.Float("cube").Evaluate(AtPoint({10.5f, 0.5f, 0.5f})), 1);
    EXPECT_EQ(s.Float("cube").Evaluate(AtPoint({10.5f, 0.5f, 1.5f})), 0);
    EXPECT_EQ(s.Float("cube").Evaluate(AtPoint({10.5f, -0.5f, 1.5f})), 1);
}

TEST(Checkerboard, AlternatesInAllDirections) {
    const TextureScene s(R"(Texture "c" "float" "checkerboard")");
    for (int i = -3; i < 3; ++i)
        for (int j = -3; j < 3; ++j)
            EXPECT_EQ(s.Float("c").Evaluate(AtUV(float(i) + 0.3f, float(j) + 0.7f)),
                      (i + j) % 2 == 0 ? 1 : 0);
}

TEST(Checkerboard, FilteredIsTheMeanOverTheFootprintsBox) {
    const TextureScene s(R"(Texture "c" "float" "checkerboard")");
    std::mt19937 rng(3);
    std::uniform_real_distribution<float> place(-2, 2), size(0.05f, 1.7f);
    for (int k = 0; k < 20; ++k) {
        TextureEvalContext ctx = AtUV(place(rng), place(rng));
        ctx.dudx = size(rng), ctx.dvdy = size(rng);
        constexpr int n = 400;
        double sum = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                sum += double(s.Float("c").Evaluate(
                    AtUV(ctx.uv.x + ctx.dudx * ((float(i) + 0.5f) / n - 0.5f),
                         ctx.uv.y + ctx.dvdy * ((float(j) + 0.5f) / n - 0.5f))));
        // A cell border moves the sum by at most half a step per axis: 4 borders / 800.
        EXPECT_NEAR(s.Float("c").Evaluate(ctx), sum / (n * n), 6e-3);
    }
}

}  // namespace
}  // namespace pbrt::test
