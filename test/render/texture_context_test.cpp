// Texture contexts sixteen at a time against one by one.

#include "pbrt/util/rng.h"
#include "render_text.h"

namespace pbrt {
namespace {

std::unique_ptr<RenderScene> EmptyScene(const std::string &camera) {
    Diagnostics log;
    SceneDescription scene;
    ParseString("LookAt 3 1 -4  0 0 0  0 1 0\n" + camera +
                    "\nSampler \"independent\" \"integer pixelsamples\" 9\nWorldBegin\n",
                "test.pbrt", ".", scene, log);
    return BuildScene(std::move(scene), {}, log);
}

/// One in four has parallel derivatives, which leave (du, dv) undetermined.
SurfaceInteraction RandomPoint(Rng &rng) {
    const auto vector = [&] {
        return Vector3f{rng.Uniform() - 0.5f, rng.Uniform() - 0.5f, rng.Uniform() - 0.5f};
    };
    SurfaceInteraction sp{};
    sp.p = vector();
    sp.n = Normalize(vector());
    sp.dpdu = vector();
    sp.dpdv = rng.Uniform() < 0.25f ? 2.f * sp.dpdu : vector();
    sp.uv = rng.Uniform2D();
    sp.faceIndex = int(100 * rng.Uniform());
    return sp;
}

void ExpectNear(float a, float b, float size) {
    EXPECT_NEAR(a, b, 1e-4f * size);
}
void ExpectNear(Vector3f a, Vector3f b) {
    ExpectNear(a.x, b.x, Length(b));
    ExpectNear(a.y, b.y, Length(b));
    ExpectNear(a.z, b.z, Length(b));
}

void ExpectLanesAsOneByOne(const RenderScene &world) {
    Rng rng(7);
    for (int round = 0; round < 100; ++round) {
        SurfaceInteractionX16 points{};
        for (int i = 0; i < kPacketSize; ++i)
            SetLane(&points, i, RandomPoint(rng));
        std::array<TextureEvalContext, kPacketSize> contexts;
        const LaneBits lanes = 0xbeef;
        world.TextureContexts(points, lanes, nullptr, &contexts);
        ForEachLane(lanes, [&](int i) {
            const TextureEvalContext a = contexts[size_t(i)];
            const TextureEvalContext b = world.TextureContext(Lane(points, i));
            EXPECT_EQ(a.p, b.p);
            EXPECT_EQ(a.n, b.n);
            EXPECT_EQ(a.uv, b.uv);
            EXPECT_EQ(a.faceIndex, b.faceIndex);
            ExpectNear(a.dpdx, b.dpdx);
            ExpectNear(a.dpdy, b.dpdy);
            // Rounding counts more, the less the derivatives differ in direction.
            const float sine = Length(Cross(Lane(points.dpdu, i), Lane(points.dpdv, i)));
            if (sine < 1e-3f) return;
            const float size = Length(b.dpdx) + Length(b.dpdy);
            for (const auto &[x, y] :
                 {std::pair{a.dudx, b.dudx}, {a.dvdx, b.dvdx}, {a.dudy, b.dudy}, {a.dvdy, b.dvdy}})
                ExpectNear(x, y, size / (sine * sine));
        });
    }
}

TEST(TextureContexts, SixteenAreAsOneByOne) {
    for (const char *camera :
         {R"(Camera "perspective" "float fov" 40)", R"(Camera "orthographic")"})
        for (const bool filters : {false, true}) {
            const auto world = EmptyScene(camera);
            ASSERT_TRUE(world);
            world->filtersTextures = filters;
            ExpectLanesAsOneByOne(*world);
        }
}

}  // namespace
}  // namespace pbrt
