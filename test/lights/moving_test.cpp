// Area lights in motion: at every time they are what lights at rest are in that place.

#include "lights/light_scene.h"
#include "pbrt/lights/light_bounds.h"
#include "pbrt/shapes/instanced.h"
#include "pbrt/shapes/sphere.h"
#include "pbrt/util/motion.h"

namespace pbrt::test {
namespace {

/// Turned, moved and stretched, by one that mirrors, too.
std::vector<Transform> Ends() {
    const Transform a = Transform::Translate({1, 0, 2}) * *Transform::Rotate(20, {1, 2, 0}),
                    b = Transform::Translate({-1, .5f, 3}) * *Transform::Rotate(130, {1, 0, 1}) *
                        *Transform::Scale({1.5f, .7f, .5f});
    const Transform mirror = *Transform::Scale({-1, 1, 1});
    return {a, b, mirror * a, mirror * b};
}

Instance Motion(const Transform &from, const Transform &to) {
    std::vector<Transform> later = KeysBetween(from, to);
    later.push_back(to);
    return {0, AffineTransform(from), std::make_unique<const std::vector<Transform>>(later)};
}

std::vector<Light> Lights(const Shape &shape, const Instance *motion,
                          const std::string &params = "") {
    const AreaScene scene("\"diffuse\" " + params, shape);
    const Entity &entity = *scene.scene.shapes.begin()->areaLight;
    Diagnostics log;
    ParamDict dict(entity.params, entity.loc, "area light", entity.colorSpace, &log);
    std::vector<Light> lights = CreateAreaLights(entity.type, dict, {shape, 1.f, motion});
    EXPECT_FALSE(log.HasErrors());
    return lights;
}

/// One triangle, or a sphere.
Shape Emitter(bool flat, const Transform &placed = Transform()) {
    if (!flat) {
        Sphere sphere;
        sphere.renderFromObject = placed;
        sphere.flipNormal = false;
        return sphere;
    }
    TriangleMesh mesh;
    mesh.p = {placed.Point({0, 0, 0}), placed.Point({2, 0, .5f}), placed.Point({.3f, 1, 0})};
    mesh.indices = {0, 1, 2};
    return mesh;
}

/// Light of `light` in the mean, seen from p, without the receiver's cosine, and its deviation.
std::pair<double, double> Seen(const Light &light, Point3f p, float time) {
    std::mt19937 rng(3);
    constexpr int n = 20000;
    double sum = 0, squares = 0;
    for (int i = 0; i < n; ++i) {
        const auto s = SampleLi(light, {p, {}, time}, UniformSquare(rng), kLambda);
        const double v = s ? double(s->L[0] / s->pdf) : 0;
        sum += v, squares += v * v;
    }
    const double mean = sum / n;
    return {mean, std::sqrt(std::max(0., squares / n - mean * mean) / n)};
}

template <typename F>
void ForEachMotion(F f) {
    const std::vector<Transform> ends = Ends();
    for (const bool flat : {true, false})
        for (size_t i = 0; i < ends.size(); i += 2)
            f(flat, Motion(ends[i], ends[i + 1]));
}

TEST(MovingAreaLight, SamplesHaveTheDensityOfHits) {
    std::mt19937 rng(1);
    ForEachMotion([&](bool flat, const Instance &motion) {
        const Shape shape = Emitter(flat);
        const std::vector<Light> lights = Lights(shape, &motion, "\"bool twosided\" true");
        int samples = 0;
        for (int i = 0; i < 2000; ++i) {
            const float time = UniformSquare(rng).x;
            const LightSampleContext ctx{6.f * UniformDirection(rng), {}, time};
            const auto s = SampleLi(lights[0], ctx, UniformSquare(rng), kLambda);
            if (!s) continue;
            ++samples;
            // The shadow ray ends on the light as it stands at that time.
            const Transform t = TransformAt(motion, time);
            const Point3f own = t.Inverse().Point(s->pLight);
            const Vector3f n = flat ? Normalize(Vector3f{-.5f, .15f, 2}) : own;
            if (flat)
                EXPECT_NEAR(Dot(own, n), 0, 1e-4f);
            else
                EXPECT_NEAR(Length(own), 1, 1e-4f);
            const Normal3f placed = Normalize(t.Normal(n));
            const float pdf = PDF_Hit(lights[0], ctx, s->pLight, placed);
            // Edge-on the cosine loses digits, and so does the density.
            const float cosine = std::abs(Dot(placed, s->wi));
            EXPECT_NEAR(pdf / s->pdf, 1, 1e-4f / std::max(cosine, 1e-3f));
        }
        EXPECT_GT(samples, 1000);
    });
}

TEST(MovingAreaLight, LightsAsOneThatRestsThere) {
    ForEachMotion([&](bool flat, const Instance &motion) {
        for (const float time : {0.f, .3f, .77f, 1.f}) {
            const Transform t = TransformAt(motion, time);
            // A stretched sphere is no sphere: its twin at rest moves from there to there.
            const Instance rest{0, AffineTransform(t)};
            const Shape shape = Emitter(flat), placed = flat ? Emitter(flat, t) : shape;
            if (flat && t.SwapsHandedness()) continue;  // its sides change when made in place
            const Light moving = Lights(shape, &motion)[0],
                        twin = Lights(placed, flat ? nullptr : &rest)[0];
            for (const Point3f p : {Point3f{0, 0, 9}, {5, 4, 1}, {-6, 1, 4}}) {
                const auto a = Seen(moving, p, time), b = Seen(twin, p, 0);
                EXPECT_NEAR(a.first, b.first, 5 * std::hypot(a.second, b.second) + 1e-4 * b.first);
            }
            if (time > 0) continue;
            EXPECT_NEAR(Power(moving) / Power(twin), 1, 1e-3f);
        }
    });
}

TEST(MovingAreaLight, BoundsHoldIt) {
    std::mt19937 rng(2);
    ForEachMotion([&](bool flat, const Instance &motion) {
        const Shape shape = Emitter(flat);
        const Light light = Lights(shape, &motion)[0];
        const LightBounds bounds = *Bounds(light);
        for (int i = 0; i < 2000; ++i) {
            const LightSampleContext ctx{6.f * UniformDirection(rng), {}, UniformSquare(rng).x};
            const auto s = SampleLi(light, ctx, UniformSquare(rng), kLambda);
            if (!s) continue;
            for (int k = 0; k < 3; ++k) {
                EXPECT_GE(s->pLight[k], bounds.bounds.min[k] - 1e-4f);
                EXPECT_LE(s->pLight[k], bounds.bounds.max[k] + 1e-4f);
            }
            EXPECT_GT(Importance(bounds, ctx.p, {}), 0);
        }
    });
}

/// A flat light that only moves keeps its direction: the tree knows what is behind it.
TEST(MovingAreaLight, FlatOnesThatDoNotTurnShineToOneSide) {
    const Instance motion =
        Motion(Transform::Translate({-1, 0, 0}), Transform::Translate({1, 0, 0}));
    const Shape shape = Rectangle(1, 1, 0);
    const Light light = Lights(shape, &motion)[0];
    EXPECT_EQ(Importance(*Bounds(light), {0, 0, -3}, {}), 0);
    EXPECT_GT(Importance(*Bounds(light), {0, 0, 3}, {}), 0);
}

}  // namespace
}  // namespace pbrt::test
