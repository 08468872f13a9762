// The double-precision intersections against oracles.

#include <gtest/gtest.h>

#include "pbrt/shapes/patch_intersection.h"
#include "pbrt/shapes/shapes.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt {
namespace {

Vector3d RandomVector(Rng &rng, double r = 1) {
    const double x = rng.Uniform(), y = rng.Uniform(), z = rng.Uniform();
    return r * Vector3d{2 * x - 1, 2 * y - 1, 2 * z - 1};
}
constexpr double kFar = 1e30;

template <typename Q>
std::optional<double> IntersectQuadric(const Q &quadric, const RayD &ray) {
    const auto hit = quadric.Intersect(0, ray);
    return hit ? std::optional(hit->t) : std::nullopt;
}

/// Roots of |o + t d| = r in long double, directly.
struct LongRoots {
    bool exist;
    long double t0, t1;
    LongRoots(Vector3d o, Vector3d d, double r) {
        const long double a =
            (long double)d.x * d.x + (long double)d.y * d.y + (long double)d.z * d.z;
        const long double b =
            (long double)o.x * d.x + (long double)o.y * d.y + (long double)o.z * d.z;
        const long double c = (long double)o.x * o.x + (long double)o.y * o.y +
                              (long double)o.z * o.z - (long double)r * r;
        const long double root = b * b - a * c;
        exist = root >= 0;
        const long double s = exist ? std::sqrt(root) : 0;
        t0 = (-b - s) / a;
        t1 = (-b + s) / a;
    }
};

TEST(IntersectSphere, RootsNearGrazingAgainstLongDouble) {
    Rng rng(1);
    const Sphere sphere{{}, 1.5f, -1.5f, 1.5f, 2 * Pi, false};
    for (int i = 0; i < 100000; ++i) {
        // A line at distance r (1 -+ 10^-k) from the center, seen from afar.
        const Vector3d d = ToDouble(SampleUniformSphere(rng.Uniform2D()));
        const Vector3d across = Normalize(Cross(d, RandomVector(rng)));
        const double nearness = std::pow(10., -1 - 7 * rng.Uniform());
        const double l = 1.5 * (1 + (rng.Below(2) ? nearness : -nearness));
        const Vector3d o = l * across - std::pow(10., 4 * rng.Uniform()) * d;
        const LongRoots expected(o, d, 1.5);
        const auto t = IntersectQuadric(sphere, RayD{o, d, 0, kFar});
        ASSERT_EQ(t.has_value(), expected.exist && expected.t1 > 0) << nearness;
        if (!t) continue;
        const long double nearest = expected.t0 > 0 ? expected.t0 : expected.t1;
        // The discriminant's error is amplified by the root: 1e-15 / sqrt(nearness), and scaled by
        // the distance.
        EXPECT_NEAR(*t, double(nearest), 1e-15 * (10 + 4 * Length(o)) / std::sqrt(nearness));
    }
}

TEST(IntersectSphere, OriginsOnTheSurfaceKnowTheirSide) {
    Rng rng(2);
    const Sphere sphere{};
    for (int i = 0; i < 100000; ++i) {
        const Vector3d n = Normalize(RandomVector(rng));
        const Vector3d d = Normalize(RandomVector(rng));
        const double away = std::pow(10., -14 + 10 * rng.Uniform());
        const auto outside = IntersectQuadric(sphere, RayD{(1 + away) * n, d, 0, kFar});
        EXPECT_TRUE(Dot(d, n) < 0 || !outside);
        const auto inside = IntersectQuadric(sphere, RayD{(1 - away) * n, d, 0, kFar});
        ASSERT_TRUE(inside);
        const double chord = std::max(0., -2 * Dot(d, n));
        EXPECT_GE(*inside, chord * 0.999);
    }
}

/// SurfaceAt puts a hit back on the surface, whatever the transform.
TEST(IntersectQuadric, FindsWhatItsParametersDescribe) {
    Rng rng(3);
    const Sphere sphere{{}, 2, -1, 1.5f, 4, false};
    const Cylinder cylinder{{}, 2, -1, 1.5f, 4, false};
    const Disk disk{{}, 0.5f, 2, 1, 4, false};
    int hits = 0;
    for (int i = 0; i < 100000; ++i) {
        const RayD ray{RandomVector(rng, 4), RandomVector(rng), 0, kFar};
        const auto check = [&](std::optional<double> t, auto on) {
            if (!t) return;
            ++hits;
            const Vector3d p = ray.o + *t * ray.d;
            EXPECT_LT(std::abs(on(p)), 1e-12);
            EXPECT_GE(p.z, -1);
            EXPECT_LE(p.z, 1.5);
            EXPECT_LE(Azimuth(float(p.x), float(p.y)), 4 + 1e-6f);
        };
        check(IntersectQuadric(sphere, ray), [](Vector3d p) { return Length(p) - 2; });
        check(IntersectQuadric(cylinder, ray),
              [](Vector3d p) { return std::sqrt(p.x * p.x + p.y * p.y) - 2; });
        check(IntersectQuadric(disk, ray), [](Vector3d p) {
            const double r = std::sqrt(p.x * p.x + p.y * p.y);
            return r >= 1 && r <= 2 ? p.z - 0.5 : 1;
        });
    }
    EXPECT_GT(hits, 10000);
}

TEST(IntersectQuadric, StartsBehindTMinAndEndsAtTMax) {
    const Sphere sphere{};
    const RayD ray{{-3, 0, 0}, {1, 0, 0}, 0, kFar};
    EXPECT_EQ(IntersectQuadric(sphere, ray), 2);
    EXPECT_EQ(IntersectQuadric(sphere, RayD{ray.o, ray.d, 2, kFar}), 4);
    EXPECT_EQ(IntersectQuadric(sphere, RayD{ray.o, ray.d, 4, kFar}), std::nullopt);
    EXPECT_EQ(IntersectQuadric(sphere, RayD{ray.o, ray.d, 0, 2}), 2);
    EXPECT_EQ(IntersectQuadric(sphere, RayD{ray.o, ray.d, 0, 1.999}), std::nullopt);
}

struct RandomPatch {
    Patch patch;
    explicit RandomPatch(Rng &rng, float bend) {
        const auto off = [&] { return bend * ToFloat(RandomVector(rng)); };
        patch = {off(), Vector3f{1, 0, 0} + off(), Vector3f{0, 1, 0} + off(),
                 Vector3f{1, 1, 0} + off()};
    }
    Vector3d At(double u, double v) const {
        return ((1 - u) * (1 - v)) * ToDouble(patch.p00) + (u * (1 - v)) * ToDouble(patch.p10) +
               ((1 - u) * v) * ToDouble(patch.p01) + (u * v) * ToDouble(patch.p11);
    }
};

TEST(IntersectPatch, HitsWhatRaysAreAimedAt) {
    Rng rng(4);
    for (int i = 0; i < 100000; ++i) {
        const RandomPatch q(rng, i % 2 == 0 ? 0.3f : 0.003f);
        const double u = 0.001 + 0.998 * rng.Uniform(), v = 0.001 + 0.998 * rng.Uniform();
        const Vector3d target = q.At(u, v), o = target + RandomVector(rng, 3);
        const Vector3d du = q.At(1, v) - q.At(0, v), dv = q.At(u, 1) - q.At(u, 0);
        const Vector3d n = Normalize(Cross(du, dv));
        const double cosine = std::abs(Dot(Normalize(target - o), n));
        if (cosine < 1e-3) continue;
        const auto hit = IntersectPatch(q.patch, {o, target - o, 0, 1 + 1e-9});
        ASSERT_TRUE(hit) << i;
        const Vector3d onRay = o + hit->t * (target - o), onPatch = q.At(hit->u, hit->v);
        EXPECT_LT(Length(onRay - onPatch), 1e-13 / cosine);
        if (std::abs(hit->t - 1) > 1e-6) continue;  // an earlier crossing
        EXPECT_NEAR(hit->u, u, 1e-12 / (cosine * cosine));
        EXPECT_NEAR(hit->v, v, 1e-12 / (cosine * cosine));
    }
}

/// Number of crossings by brute force: two triangles of each cell of a fine grid.
int CrossingsOfGrid(const RandomPatch &q, Vector3d o, Vector3d d, int n) {
    int count = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const auto at = [&](int di, int dj) {
                return q.At(double(i + di) / n, double(j + dj) / n);
            };
            const Vector3d corners[2][3] = {{at(0, 0), at(1, 0), at(1, 1)},
                                            {at(0, 0), at(1, 1), at(0, 1)}};
            for (const auto &c : corners) {
                const auto side = [&](int a, int b) { return Dot(d, Cross(c[a] - o, c[b] - o)); };
                const double s0 = side(0, 1), s1 = side(1, 2), s2 = side(2, 0);
                count += (s0 > 0 && s1 > 0 && s2 > 0) || (s0 < 0 && s1 < 0 && s2 < 0);
            }
        }
    return count;
}

TEST(IntersectPatch, MissesWhatIsNotThere) {
    Rng rng(5);
    int hits = 0, different = 0;
    for (int i = 0; i < 3000; ++i) {
        const RandomPatch q(rng, 0.3f);
        const Vector3d o = Vector3d{0.5, 0.5, 0} + RandomVector(rng, 3);
        const Vector3d d = Vector3d{0.5, 0.5, 0} + RandomVector(rng, 0.9) - o;
        int found = 0;
        // The line has no ends: start far behind.
        for (double tMin = 0;;) {
            const auto hit = IntersectPatch(q.patch, {o - 100. * d, d, tMin, kFar});
            if (!hit) break;
            ++found;
            tMin = hit->t;
        }
        hits += found;
        different += found != CrossingsOfGrid(q, o, d, 24);
    }
    EXPECT_GT(hits, 500);
    // The grid is not the patch: silhouettes and rims differ within 1e-3 of its size.
    EXPECT_LT(different, 20);
}

TEST(InvertPatch, RecoversUV) {
    Rng rng(6);
    for (int i = 0; i < 20000; ++i) {
        const RandomPatch q(rng, 0.2f);
        const float u = rng.Uniform(), v = rng.Uniform();
        const Point3f p = ToFloat(q.At(u, v));
        const Point2f uv =
            InvertPatch(q.patch, p, PatchNormal(q.patch, q.patch.DpDu(v), q.patch.DpDv(u)));
        EXPECT_NEAR(uv.x, u, 2e-6f);
        EXPECT_NEAR(uv.y, v, 2e-6f);
    }
}

}  // namespace
}  // namespace pbrt
