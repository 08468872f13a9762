// Every camera, by its examples.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pbrt/cameras/cameras.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

constexpr Point2i kResolution{60, 40};

/// Seen from (3, 1, -4); `before` comes before LookAt. Read without a message.
Camera Made(std::string_view type, std::string_view example, std::string_view before = "") {
    Diagnostics log;
    SceneDescription scene;
    const std::string text = fmt::format(
        "{}\nLookAt 3 1 -4  0 0 0  0 1 0\nCamera \"{}\" {} \"float shutterclose\" 0.5\nWorldBegin",
        before, type, example);
    ParseString(text, "test.pbrt", "", scene, log);
    const Camera camera = CreateCamera(scene, kResolution, log);
    EXPECT_TRUE(log.Messages().empty()) << text;
    return camera;
}

template <typename C>
class EveryCamera : public testing::Test {
  protected:
    static std::vector<Camera> Cameras() {
        std::vector<Camera> cameras;
        for (const std::string_view example : C::kExamples) {
            cameras.push_back(Made(C::kName, example));
            cameras.push_back(Made(C::kName, example, "Scale -1 1 1"));
        }
        return cameras;
    }
};
template <typename List>
struct TypesOf;
template <typename... Cs>
struct TypesOf<TypeList<Cs...>> {
    using Types = testing::Types<Cs...>;
};
TYPED_TEST_SUITE(EveryCamera, TypesOf<CameraTypes>::Types);

Point2f OnFilm(Rng &rng) {
    const Point2f u = rng.Uniform2D();
    return {u.x * kResolution.x, u.y * kResolution.y};
}

TYPED_TEST(EveryCamera, RaysAreUnitAndStartWithinOrigins) {
    Rng rng(1);
    for (const Camera &camera : this->Cameras()) {
        const Bounds3f bounds = Origins(camera);
        const float size = 1e-5f * (1 + Length(bounds.max - bounds.min));
        for (int i = 0; i < 1000; ++i) {
            const Ray ray = GenerateRay(camera, OnFilm(rng), rng.Uniform2D(), rng.Uniform());
            EXPECT_NEAR(Length(ray.d), 1, 1e-6f);
            EXPECT_EQ(ray.tMax, Infinity);
            EXPECT_TRUE(ray.time >= 0 && ray.time <= 0.5f);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(ray.o[axis], bounds.min[axis] - size);
                EXPECT_LE(ray.o[axis], bounds.max[axis] + size);
            }
        }
    }
}

TYPED_TEST(EveryCamera, WithoutALensTheNumbersOfItChangeNothing) {
    Rng rng(2);
    for (const Camera &camera : this->Cameras()) {
        if (HasLens(camera)) continue;
        for (int i = 0; i < 100; ++i) {
            const Point2f film = OnFilm(rng);
            const Ray a = GenerateRay(camera, film, rng.Uniform2D(), 0);
            const Ray b = GenerateRay(camera, film, rng.Uniform2D(), 0);
            EXPECT_EQ(a.o, b.o);
            EXPECT_EQ(a.d, b.d);
        }
    }
}

/// But for the rounding of contracted products: of coordinates up to 6, and of directions.
TYPED_TEST(EveryCamera, SixteenRaysAreAsOneByOne) {
    Rng rng(3);
    for (const Camera &camera : this->Cameras()) {
        Point2fX16 film, lens;
        FloatX16 time;
        for (int i = 0; i < kPacketSize; ++i) {
            SetLane(&film, i, OnFilm(rng));
            SetLane(&lens, i, rng.Uniform2D());
            time.Set(i, rng.Uniform());
        }
        const RayPacket rays = GenerateRays(camera, film, lens, time);
        for (int i = 0; i < kPacketSize; ++i) {
            const Ray a = rays.At(i),
                      b = GenerateRay(camera, Lane(film, i), Lane(lens, i), time[i]);
            EXPECT_LT(Length(a.o - b.o), 4e-6f);
            EXPECT_LT(Length(a.d - b.d), 2e-6f);
            EXPECT_EQ(a.time, b.time);
        }
    }
}

/// The middle of the pixel that looks most nearly along the camera's axis.
Point2f AxisOnFilm(const Camera &camera) {
    const Vector3f axis = Placement(camera).Forward();
    Point2f nearest;
    float best = -Infinity;
    for (int y = 0; y < kResolution.y; ++y) {
        for (int x = 0; x < kResolution.x; ++x) {
            const Point2f film{float(x) + 0.5f, float(y) + 0.5f};
            const float cosine = Dot(GenerateRay(camera, film, {}, 0).d, axis);
            if (cosine > best) best = cosine, nearest = film;
        }
    }
    return nearest;
}

/// At points along the rays of a camera without a lens: it looks along the ray, and the neighbours
/// of that on the axis are `step` apart. 5 %: over pixels that are a thirtieth of the field of
/// view.
TYPED_TEST(EveryCamera, ViewsArePointsAlongTheirRays) {
    Rng rng(4);
    for (const Camera &camera : this->Cameras()) {
        if (HasLens(camera)) continue;
        for (int i = 0; i < 100; ++i) {
            const Ray ray = GenerateRay(camera, OnFilm(rng), {}, 0);
            const CameraView<float> view = ViewAt(camera, ray.o + 3.f * ray.d);
            EXPECT_LT(Length(view.direction - ray.d), 1e-5f);
            EXPECT_GT(Length(Cross(Normalize(view.right), view.direction)), 1e-3f);
        }
        const Point2f middle = AxisOnFilm(camera);
        const auto at = [&](float dx) {
            const Ray ray = GenerateRay(camera, {middle.x + dx, middle.y}, {}, 0);
            return ray.o + 3.f * ray.d;
        };
        const CameraView<float> view = ViewAt(camera, at(0));
        const Vector3f step = at(0.5f) - at(-0.5f);
        EXPECT_NEAR(Length(step), view.step, 0.05f * view.step);
        EXPECT_GT(Dot(step, view.right), 0);
    }
}

TYPED_TEST(EveryCamera, SixteenViewsAreAsOneByOne) {
    Rng rng(5);
    for (const Camera &camera : this->Cameras()) {
        Point3fX16 p;
        for (int i = 0; i < kPacketSize; ++i)
            SetLane(&p, i, 10.f * SampleUniformSphere(rng.Uniform2D()));
        const CameraView<FloatX16> views = ViewAt(camera, p);
        for (int i = 0; i < kPacketSize; ++i) {
            const CameraView<float> view = ViewAt(camera, Lane(p, i));
            EXPECT_LT(Length(Lane(views.direction, i) - view.direction), 2e-6f);
            EXPECT_EQ(Lane(views.right, i), view.right);
            EXPECT_NEAR(views.step[i], view.step, 2e-6f * view.step);
        }
    }
}

}  // namespace
}  // namespace pbrt
