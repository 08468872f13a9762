// Moving cameras: their rays are those of cameras at rest where they are at the time.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pbrt/cameras/cameras.h"
#include "pbrt/util/motion.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

/// `start` and `end`: directives before Camera at the two times.
Camera Made(const std::string &start, const std::string &end, const std::string &camera,
            const std::string &space = "world", int errors = 0) {
    Diagnostics log;
    SceneDescription scene;
    scene.options.renderCoordSys = space;
    ParseString(fmt::format("ActiveTransform StartTime {} ActiveTransform EndTime {} "
                            "ActiveTransform All Camera {} WorldBegin",
                            start, end, camera),
                "test.pbrt", "", scene, log);
    const Camera made = CreateCamera(scene, {60, 40}, log);
    EXPECT_EQ(log.ErrorCount(), errors);
    return made;
}

constexpr char kFrom[] = "LookAt 3 1 -4  0 0 0  0 1 0", kTo[] = "LookAt 2 2 -3  1 0 0  0 1 .2";

/// The tolerance is KeysBetween's, of lengths up to 5, and that of directions.
TEST(MovingCamera, RaysAreThoseOfACameraThatRestsThere) {
    Rng rng(1);
    for (const char *const type :
         {"\"perspective\"", "\"orthographic\" \"float lensradius\" .1", "\"spherical\""}) {
        const Camera moving = Made(kFrom, kTo, type);
        const Transform from = Placement(Made(kFrom, kFrom, type)).renderFromCamera,
                        to = Placement(Made(kTo, kTo, type)).renderFromCamera;
        for (int i = 0; i < 500; ++i) {
            const Point2f film{60 * rng.Uniform(), 40 * rng.Uniform()}, lens = rng.Uniform2D();
            const float time = i < 2 ? float(i) : rng.Uniform();
            const Ray ray = GenerateRay(moving, film, lens, time);
            const Transform there = *InterpolateMotion(from, to, time);
            // A camera at rest, moved from its place.
            const Ray rest = GenerateRay(Made(kFrom, kFrom, type), film, lens, time);
            const Transform move = there * from.Inverse();
            EXPECT_LT(Length(ray.o - move.Point(rest.o)), 6e-3f);
            EXPECT_LT(Length(ray.d - Normalize(move.Vector(rest.d))), 2e-3f);
            EXPECT_NEAR(Length(ray.d), 1, 1e-6f);
            const Bounds3f all = Origins(moving);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(ray.o[axis], all.min[axis] - 1e-5f);
                EXPECT_LE(ray.o[axis], all.max[axis] + 1e-5f);
            }
            if (i >= 20) continue;
            // In camera space of the start the picture is the same.
            const Camera other = Made(kFrom, kTo, type, "camera");
            const Ray inCamera = GenerateRay(other, film, lens, time);
            const Vector3f d = Placement(other).renderFromWorld.Inverse().Vector(inCamera.d);
            EXPECT_LT(Length(d - ray.d), 2e-3f);
        }
    }
}

TEST(MovingCamera, SixteenRaysAreAsOneByOne) {
    Rng rng(2);
    const Camera camera = Made(kFrom, kTo, "\"perspective\"");
    Point2fX16 film, lens;
    FloatX16 time;
    for (int i = 0; i < kPacketSize; ++i) {
        SetLane(&film, i, Point2f{60 * rng.Uniform(), 40 * rng.Uniform()});
        SetLane(&lens, i, rng.Uniform2D());
        time.Set(i, rng.Uniform());
    }
    const RayPacket rays = GenerateRays(camera, film, lens, time);
    for (int i = 0; i < kPacketSize; ++i) {
        const Ray a = rays.At(i), b = GenerateRay(camera, Lane(film, i), Lane(lens, i), time[i]);
        EXPECT_LT(Length(a.o - b.o), 4e-6f);
        EXPECT_LT(Length(a.d - b.d), 2e-6f);
    }
}

TEST(MovingCamera, MirroringOnTheWayIsAnError) {
    Made("Translate 0 0 1", "Scale -1 1 1", "\"perspective\"", "world", 1);
}

TEST(MovingCamera, MotionThatCannotBeTracedIsAnError) {
    for (const char *const type : {"\"perspective\"", "\"orthographic\"", "\"spherical\""})
        for (const char *const end : {"Translate 1e19 0 0", "Scale 1e-39 1 1", "Scale 1e-30 1 1"})
            Made("", end, type, "world", 1);
}

}  // namespace
}  // namespace pbrt
