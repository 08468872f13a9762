// Relief that shading shows: displacement and normalmap.

#include <fmt/format.h>

#include <random>

#include "materials/material_text.h"
#include "pbrt/image/image.h"

namespace pbrt::test {
namespace {

struct HeightOf : FloatNode {
    float (*height)(const TextureEvalContext &);
    explicit HeightOf(float (*height)(const TextureEvalContext &)) : height(height) {}
    float Evaluate(const TextureEvalContext &ctx) const override { return height(ctx); }
};

/// The relief of a function of the context; null where it has none.
std::shared_ptr<const BumpMap> ReliefOf(float (*height)(const TextureEvalContext &)) {
    NamedTextures named;
    named.floats["h"] = FloatTexture(std::make_shared<HeightOf>(height));
    MaterialText text("Material \"diffuse\" \"texture displacement\" \"h\"");
    const Entity entity = text.scene.materials.Take();
    Diagnostics log;
    ParamDict params(entity.params, entity.loc, "material", entity.colorSpace, &log, "");
    return BumpMap::Create(params, named);
}

/// A point of a plane whose x and y are u and v, up to scale.
SurfaceInteraction Plane(Vector3f dpdu = {1, 0, 0}, Vector3f dpdv = {0, 1, 0}) {
    SurfaceInteraction sp{};
    sp.n = sp.ns = Normalize(Cross(dpdu, dpdv));
    sp.dpdu = sp.dpdus = dpdu, sp.dpdv = dpdv;
    return sp;
}

void ExpectNear(Vector3f a, Vector3f b, float tolerance) {
    EXPECT_LT(Length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

TEST(BumpMap, SlopesTiltAsTheDisplacedPlane) {
    const auto relief = ReliefOf([](const TextureEvalContext &c) { return c.uv.x - 2 * c.uv.y; });
    for (const Vector3f dpdu : {Vector3f{1, 0, 0}, {3, 0, 0}, {0.5f, 0.2f, 0}}) {
        SurfaceInteraction sp = Plane(dpdu);
        relief->Tilt(AtUV(0.3f, 0.4f), &sp);
        const Vector3f u = dpdu + Vector3f{0, 0, 1}, v{0, 1, -2};
        // Differences of heights of size 1 over steps of 5e-4: 1e-7 / 5e-4.
        ExpectNear(sp.ns, Normalize(Cross(u, v)), 1e-3f);
        ExpectNear(sp.dpdus, u, 1e-3f);
    }
}

TEST(BumpMap, HeightsByPointAndByUVTiltAlike) {
    const auto byUV = ReliefOf([](const TextureEvalContext &c) { return 0.5f * c.uv.x; });
    const auto byPoint = ReliefOf([](const TextureEvalContext &c) { return 0.25f * c.p.x; });
    SurfaceInteraction a = Plane({2, 0, 0}), b = a;
    byUV->Tilt(AtUV(0, 0), &a);
    byPoint->Tilt(AtUV(0, 0), &b);
    ExpectNear(a.ns, b.ns, 1e-3f);
}

TEST(BumpMap, NormalsStayUnitAndOnTheirSide) {
    const auto steep = ReliefOf(
        [](const TextureEvalContext &c) { return 1e3f * std::sin(1e3f * c.uv.x + 77 * c.uv.y); });
    std::mt19937 random(1);
    std::uniform_real_distribution<float> u(-1, 1);
    const auto any = [&] { return Vector3f{u(random), u(random), u(random)}; };
    for (int i = 0; i < 10000; ++i) {
        SurfaceInteraction sp = Plane(any(), any());
        if (i % 2) sp.n = -sp.n, sp.ns = -sp.ns;
        // Shading normals of a mesh, up to the horizon.
        sp.ns = Normalize(sp.ns + any());
        if (Dot(sp.ns, sp.n) < 0) sp.ns = -sp.ns;
        steep->Tilt(AtUV(u(random), u(random)), &sp);
        EXPECT_NEAR(Length(sp.ns), 1, 1e-5f);
        EXPECT_GE(Dot(sp.ns, sp.n), 0);
        const Frame frame = sp.ShadingFrame();
        EXPECT_NEAR(Dot(frame.x, frame.z), 0, 1e-4f);
    }
}

TEST(BumpMap, MirroredSurfacesTiltMirrored) {
    const auto relief = ReliefOf([](const TextureEvalContext &c) { return c.uv.x + 3 * c.uv.y; });
    const auto mirrored = [](Vector3f v) { return Vector3f{-v.x, v.y, v.z}; };
    SurfaceInteraction sp = Plane({1, 0.2f, 0}, {0.1f, 1, 0.4f}), image = sp;
    for (Vector3f SurfaceInteraction::*v :
         {&SurfaceInteraction::n, &SurfaceInteraction::ns, &SurfaceInteraction::dpdu,
          &SurfaceInteraction::dpdv, &SurfaceInteraction::dpdus})
        image.*v = mirrored(sp.*v);
    relief->Tilt(AtUV(0, 0), &sp);
    relief->Tilt(AtUV(0, 0), &image);
    ExpectNear(image.ns, mirrored(sp.ns), 1e-6f);
    ExpectNear(image.ShadingFrame().y, mirrored(sp.ShadingFrame().y), 1e-6f);
}

TEST(BumpMap, WithoutANormalNothingIsTilted) {
    const auto nan = ReliefOf([](const TextureEvalContext &) { return std::nanf(""); });
    const auto slope = ReliefOf([](const TextureEvalContext &c) { return c.uv.x; });
    SurfaceInteraction sp = Plane();
    nan->Tilt(AtUV(0, 0), &sp);
    ExpectNear(sp.ns, {0, 0, 1}, 1e-6f);
    ExpectNear(sp.dpdus, {1, 0, 0}, 1e-6f);
    SurfaceInteraction degenerate = Plane();
    degenerate.dpdu = degenerate.dpdv = {};
    slope->Tilt(AtUV(0, 0), &degenerate);
    ExpectNear(degenerate.ns, {0, 0, 1}, 1e-6f);
}

/// A material with a normal map of one colour.
std::shared_ptr<const BumpMap> NormalMapOf(RGB rgb) {
    const std::string file = testing::TempDir() + "bump_map_normal.pfm";
    Image image({1, 1}, {"R", "G", "B"});
    image.Set({0, 0}, 0, rgb.r), image.Set({0, 0}, 1, rgb.g), image.Set({0, 0}, 2, rgb.b);
    EXPECT_FALSE(WriteImage(image, file));
    const MaterialText text(fmt::format("Material \"diffuse\" \"string normalmap\" \"{}\"", file));
    EXPECT_EQ(text.Messages(), "");
    return text.material->bump;
}

TEST(BumpMap, NormalMapsAreInTheShadingFrame) {
    SurfaceInteraction sp = Plane({2, 0, 0}, {0, 0, 3});
    const Frame frame = sp.ShadingFrame();
    NormalMapOf({0.8f, 0.5f, 0.9f})->Tilt(AtUV(0.1f, 0.2f), &sp);
    ExpectNear(sp.ns, Normalize(0.6f * frame.x + 0.8f * frame.z), 1e-6f);
    SurfaceInteraction straight = Plane();
    NormalMapOf({0.5f, 0.5f, 1})->Tilt(AtUV(0, 0), &straight);
    ExpectNear(straight.ns, {0, 0, 1}, 1e-6f);
}

TEST(BumpMap, ConstantHeightsAreNone) {
    EXPECT_EQ(MaterialText("Material \"diffuse\"").material->bump, nullptr);
    EXPECT_EQ(MaterialText("Texture \"c\" \"float\" \"constant\" \"float value\" .3\n"
                           "Material \"diffuse\" \"texture displacement\" \"c\"")
                  .material->bump,
              nullptr);
}

TEST(BumpMap, HairKnowsNoDisplacement) {
    const MaterialText text(
        "Texture \"c\" \"float\" \"checkerboard\"\n"
        "Material \"hair\" \"texture displacement\" \"c\"");
    EXPECT_NE(text.Messages().find("displacement"), std::string::npos);
}

}  // namespace
}  // namespace pbrt::test
