// The spherical camera: its maps in closed form.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pbrt/cameras/cameras.h"
#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

/// At the origin of camera space, which is world space, with a film of 100 x 100 pixels.
Camera Made(const std::string &parameters) {
    Diagnostics log;
    SceneDescription scene;
    ParseString("Camera \"spherical\" " + parameters + " WorldBegin", "test.pbrt", "", scene, log);
    const Camera camera = CreateCamera(scene, {100, 100}, log);
    EXPECT_TRUE(log.Messages().empty()) << parameters;
    return camera;
}
Vector3f DirectionAt(const Camera &camera, float x, float y) {
    return GenerateRay(camera, {x, y}, {}, 0).d;
}
void ExpectNear(Vector3f a, Vector3f b) {
    EXPECT_LT(Length(a - b), 2e-6f) << a.x << ' ' << a.y << ' ' << a.z;
}

// Up is y, forward z, right x.

TEST(SphericalCamera, EquirectangularIsLongitudeAndColatitude) {
    const Camera camera = Made("\"string mapping\" \"equirectangular\"");
    ExpectNear(DirectionAt(camera, 0, 50), {1, 0, 0});
    ExpectNear(DirectionAt(camera, 25, 50), {0, 0, 1});
    ExpectNear(DirectionAt(camera, 50, 50), {-1, 0, 0});
    ExpectNear(DirectionAt(camera, 77, 0), {0, 1, 0});
    ExpectNear(DirectionAt(camera, 33, 100), {0, -1, 0});
    const float s = std::sqrt(0.5f);
    ExpectNear(DirectionAt(camera, 25, 25), {0, s, s});
}

TEST(SphericalCamera, EqualAreaHasTheZenithInTheMiddle) {
    const Camera camera = Made("");
    ExpectNear(DirectionAt(camera, 50, 50), {0, 1, 0});
    ExpectNear(DirectionAt(camera, 100, 50), {1, 0, 0});
    ExpectNear(DirectionAt(camera, 50, 100), {0, 0, 1});
    ExpectNear(DirectionAt(camera, 0, 0), {0, -1, 0});
}

/// Mean of d and of its squares over the sphere: 0 and 1/3. 300^2 midpoints: the map is smooth but
/// at folds, so that the error goes by the pixels' size squared.
TEST(SphericalCamera, EqualAreaGivesEachPixelTheSameSolidAngle) {
    const Camera camera = Made("");
    constexpr int kPixels = 300;
    Vec3<double> sum{}, squares{};
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const Vector3f d = DirectionAt(camera, 100 * (float(x) + 0.5f) / kPixels,
                                           100 * (float(y) + 0.5f) / kPixels);
            for (int c = 0; c < 3; ++c)
                sum[c] += d[c], squares[c] += double(d[c]) * d[c];
        }
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum[c] / (kPixels * kPixels), 0, 1e-4);
        EXPECT_NEAR(squares[c] / (kPixels * kPixels), 1 / 3., 1e-4);
    }
}

/// Wide filters ask for positions beyond the film: what lies over an edge of the square is as near
/// as a neighbour.
TEST(SphericalCamera, EqualAreaGoesOnOverTheEdges) {
    const Camera camera = Made("");
    Rng rng(1);
    for (int i = 0; i < 1000; ++i) {
        const float along = 100 * rng.Uniform();
        for (const float edge : {0.f, 100.f}) {
            EXPECT_LT(Length(DirectionAt(camera, edge - 0.5f, along) -
                             DirectionAt(camera, edge + 0.5f, along)),
                      0.1f);
            EXPECT_LT(Length(DirectionAt(camera, along, edge - 0.5f) -
                             DirectionAt(camera, along, edge + 0.5f)),
                      0.1f);
        }
    }
}

TEST(SphericalCamera, TakesAndIgnoresTheLens) {
    const Camera plain = Made(""), lens = Made(
                                       "\"float lensradius\" 3 \"float focaldistance\" 2 \"float "
                                       "screenwindow\" [ -1 1 -2 2 ] \"float frameaspectratio\" 2");
    EXPECT_FALSE(HasLens(lens));
    ExpectNear(DirectionAt(plain, 31, 77), DirectionAt(lens, 31, 77));
}

TEST(SphericalCamera, MustStandWhereRaysCanBeTraced) {
    for (const char *const placed : {"Scale 1e25 1e25 1e25", "Scale 1e-25 1e-25 1e-25"}) {
        Diagnostics log;
        SceneDescription scene;
        ParseString(fmt::format("{} Camera \"spherical\" WorldBegin", placed), "test.pbrt", "",
                    scene, log);
        CreateCamera(scene, {100, 100}, log);
        EXPECT_EQ(log.ErrorCount(), 1) << placed;
    }
}

}  // namespace
}  // namespace pbrt
