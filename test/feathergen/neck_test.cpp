// A covered neck: feathers lie on each other like shingles.

#include "grow_test.h"
#include "pbrt/util/rng.h"

namespace pbrt::feathergen {
namespace {

using Neck = Grown;

/// Coarse feathers: their places are those of fine ones.
const std::vector<std::string> kCoarse{"neck",  "--seed",        "7", "--set", "quads_along=8",
                                       "--set", "quads_across=2"};

std::vector<std::string> CoarseTo(const std::string &out) {
    std::vector<std::string> args = kCoarse;
    args.insert(args.end(), {"--out", out});
    return args;
}

/// Instances that the ray meets, in order, each once.
std::vector<uint32_t> InstancesAlong(const RenderScene &world, Ray ray) {
    std::vector<uint32_t> met;
    Hit hit;
    while (world.accel->Intersect(ray, &hit) && hit.instance != ~0u) {
        if (std::find(met.begin(), met.end(), hit.instance) == met.end())
            met.push_back(hit.instance);
        ray.o = world.SurfaceAt(hit, ray).OffsetOrigin(ray.d);
    }
    return met;
}

TEST_F(Neck, EnoughFeathersAndQuads) {
    const std::string said = Succeed({"neck", "--out", Path("out")});
    int feathers = 0, kinds = 0;
    long quads = 0;
    ASSERT_EQ(
        std::sscanf(said.c_str(), "%d feathers of %d kinds, %ld quads", &feathers, &kinds, &quads),
        3);
    EXPECT_GE(feathers, 300);
    EXPECT_LE(kinds, 16);
    EXPECT_GE(quads, 10'000'000);
}

TEST_F(Neck, OuterFeathersLieAboveTheNext) {
    Succeed(CoarseTo(Path("out")));
    const auto world = Scene("out/neck.pbrt");
    ASSERT_TRUE(world);
    EXPECT_GE(world->instances.size(), 300u);
    // Feathers are laid from the breast up, so that those of higher number lie above.
    Rng rng(1);
    int pairs = 0, inOrder = 0;
    for (int i = 0; i < 20000; ++i) {
        const float phi = 2 * Pi * rng.Uniform(), z = -60 + 50 * rng.Uniform();
        const Vector3f out{std::cos(phi), std::sin(phi), 0};
        const auto met = InstancesAlong(*world, {Point3f{0, 0.1f * z, z} + 60.f * out, -out});
        if (met.size() < 2) continue;
        ++pairs;
        inOrder += met[0] > met[1];
    }
    EXPECT_GT(pairs, 10000);
    EXPECT_GT(double(inOrder) / pairs, 0.97);
}

TEST_F(Neck, SameSeedSameBytes) {
    Succeed(CoarseTo(Path("out")));
    const std::string first = Bytes("out/neck.pbrt");
    Succeed(CoarseTo(Path("out")));
    EXPECT_EQ(Bytes("out/neck.pbrt"), first);
}

TEST_F(Neck, CoversAGivenMesh) {
    Put("plate.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n0 40 0\n0 40 40\n0 0 40\n4 0 1 2 3\n");
    std::vector<std::string> args = CoarseTo(Path("out"));
    args.insert(args.end(), {"--surface", Path("plate.ply"), "--flow", "0,1,-1"});
    Succeed(args);
    const auto world = Scene("out/neck.pbrt");
    ASSERT_TRUE(world);
    ASSERT_GT(world->instances.size(), 30u);
    for (const Instance &instance : world->instances) {
        const Transform t = instance.Key(0);
        EXPECT_NEAR(t.Point({0, 0, 0}).x, 0, 1e-3) << "roots on the plate";
        EXPECT_GT(t.Vector({0, 0, 1}).x, 0) << "outer faces out";
        EXPECT_GT(Dot(t.Vector({0, 1, 0}), Vector3f{0, 1, -1}), 0) << "tips with the flow";
    }
}

}  // namespace
}  // namespace pbrt::feathergen
