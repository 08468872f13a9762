// Emitters whose areas and solid angles are known. What holds for every shape: laws_test.cpp.

#include "pbrt/util/sampling.h"
#include "pbrt/util/rng.h"
#include "shapes/make.h"

namespace pbrt {
namespace {

TEST(Sampling, MeanInverseAreaDensityIsTheArea) {
    const struct {
        std::string_view text;
        double area;
    } known[] = {
        {R"(Shape "trianglemesh" "point3 P" [ 0 0 0  2 0 0  0 3 0 ])", 3},
        {R"(Shape "bilinearmesh" "point3 P" [ 0 0 0  2 0 0  0 1 0  1 2 0 ])", 2.5},
        {R"(Shape "sphere" "float radius" 2)", 16 * M_PI},
        {R"(Scale 3 3 3 Shape "sphere" "float zmin" 0 "float phimax" 90)", 9 * M_PI / 2},
        // A spheroid with semi-axes 1, 1, 2: 2 pi (1 + 2 asin(e) / e), e^2 = 3/4.
        {R"(Scale 1 1 2 Shape "sphere")",
         2 * M_PI * (1 + 2 * std::asin(std::sqrt(0.75)) / std::sqrt(0.75))},
        {R"(Scale 2 1 7 Shape "disk" "float innerradius" 0.5)", 1.5 * M_PI},
        {R"(Shape "cylinder" "float radius" 2 "float zmax" 2 "float phimax" 180)", 6 * M_PI},
        // Perimeter of the ellipse with semi-axes 2 and 1 is 9.688448220547675.
        {R"(Scale 2 1 1 Shape "cylinder")", 2 * 9.688448220547675}};
    for (const auto &[text, area] : known) {
        const Shape shape = MakeOne(text);
        EXPECT_NEAR(Area(shape, 0) / area, 1, 2e-4) << text;
        double sum = 0;
        const int n = 256;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                sum += 1 / SampleArea(shape, 0, {(i + 0.5f) / n, (j + 0.5f) / n})->pdf;
        EXPECT_NEAR(sum / (n * n) / area, 1, 2e-4) << text;
    }
    // A bent patch: the two independent ways agree.
    const Shape bent = MakeOne(R"(Shape "bilinearmesh" "point3 P" [ 0 0 0  2 0 0  0 1 0  2 2 1 ])");
    double sum = 0;
    const int n = 512;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += 1 / SampleArea(bent, 0, {(i + 0.5f) / n, (j + 0.5f) / n})->pdf;
    EXPECT_NEAR(sum / (n * n) / Area(bent, 0), 1, 2e-4);
}

/// Solid angle of the triangle in double (Van Oosterom and Strackee).
double TriangleSolidAngle(const Point3f corners[3], Point3f ref) {
    Vec3<double> v[3];
    for (int i = 0; i < 3; ++i)
        v[i] = Normalize(ToDouble(corners[i]) - ToDouble(ref));
    const double det = Dot(v[0], Cross(v[1], v[2]));
    return 2 * std::abs(std::atan2(det, 1 + Dot(v[0], v[1]) + Dot(v[1], v[2]) + Dot(v[2], v[0])));
}

TEST(Sampling, TrianglesBySolidAngle) {
    Rng rng(5);
    int bySolidAngle = 0;
    for (int i = 0; i < 300; ++i) {
        TriangleMesh mesh;
        Point3f corners[3];
        for (Point3f &p : corners)
            p = SampleUniformSphere(rng.Uniform2D());
        mesh.p.assign(corners, corners + 3);
        mesh.indices = {0, 1, 2};
        const Shape shape = mesh;
        const Point3f ref =
            std::pow(10.f, 2.5f * rng.Uniform() - 1) * SampleUniformSphere(rng.Uniform2D());
        const double expected = TriangleSolidAngle(corners, ref);
        // The mean of 1 / pdf is the solid angle; constant where sampling is by solid angle.
        double sum = 0;
        int n = 0;
        bool isConstant = true;
        float first = 0;
        for (int k = 0; k < 1024; ++k) {
            const Point2f u{((k % 32) + 0.5f) / 32, ((k / 32) + 0.5f) / 32};
            const auto s = SampleFrom(shape, 0, ref, u);
            if (!s) continue;
            if (n++ == 0) first = s->pdf;
            isConstant &= s->pdf == first;
            sum += 1 / s->pdf;
            // On the triangle, and where the direction meets it.
            const Normal3f normal = UnitCross(corners[1] - corners[0], corners[2] - corners[0]);
            EXPECT_NEAR(Dot(normal, s->p - corners[0]), 0, 2e-6f);
        }
        if (isConstant && n > 0) {
            ++bySolidAngle;
            EXPECT_NEAR(sum / n / expected, 1, 1e-3);
        } else if (expected > 0.01 && expected < 6) {
            ADD_FAILURE() << "solid angle " << expected << " sampled by area";
        }
    }
    EXPECT_GT(bySolidAngle, 200);
}

TEST(Sampling, TriangleSolidAngleAgainstUniformDirections) {
    Rng rng(6);
    for (int i = 0; i < 10; ++i) {
        TriangleMesh mesh;
        for (int k = 0; k < 3; ++k)
            mesh.p.push_back(SampleUniformSphere(rng.Uniform2D()));
        mesh.indices = {0, 1, 2};
        const Shape shape = mesh;
        const Point3f ref = 0.5f * SampleUniformSphere(rng.Uniform2D());
        const auto s = SampleFrom(shape, 0, ref, {0.5f, 0.5f});
        if (!s) continue;
        int inside = 0;
        const int n = 65536;
        Vector3f c[3];
        for (int k = 0; k < 3; ++k)
            c[k] = mesh.p[size_t(k)] - ref;
        for (int k = 0; k < n; ++k) {
            const Vector3f w = SampleUniformSphere(rng.Uniform2D());
            const float a = Dot(w, Cross(c[0], c[1])), b = Dot(w, Cross(c[1], c[2])),
                        d = Dot(w, Cross(c[2], c[0])), det = Dot(c[0], Cross(c[1], c[2]));
            inside += a * det > 0 && b * det > 0 && d * det > 0;
        }
        const float share = 1 / (s->pdf * 4 * Pi);
        EXPECT_NEAR(float(inside) / n, share, 5 * std::sqrt(share * (1 - share) / n)) << "5 sigma";
    }
}

TEST(Sampling, RectanglesBySolidAngle) {
    Rng rng(7);
    int bySolidAngle = 0;
    for (int i = 0; i < 600; ++i) {
        const Frame frame = Frame::FromZ(SampleUniformSphere(rng.Uniform2D()));
        const float a = 0.2f + rng.Uniform(), b = 0.2f + rng.Uniform();
        BilinearMesh mesh;
        const Point3f corner = 0.5f * SampleUniformSphere(rng.Uniform2D());
        mesh.p = {corner, corner + a * frame.x, corner + b * frame.y,
                  corner + a * frame.x + b * frame.y};
        mesh.indices = {0, 1, 2, 3};
        mesh.planar = true;
        const Shape shape = mesh;
        const Point3f ref =
            std::pow(10.f, 1.5f * rng.Uniform() - 1) * SampleUniformSphere(rng.Uniform2D());
        const Point3f t0[3] = {mesh.p[0], mesh.p[1], mesh.p[2]},
                      t1[3] = {mesh.p[3], mesh.p[1], mesh.p[2]};
        const double expected = TriangleSolidAngle(t0, ref) + TriangleSolidAngle(t1, ref);
        const auto s = SampleFrom(shape, 0, ref, rng.Uniform2D());
        const auto t = SampleFrom(shape, 0, ref, rng.Uniform2D());
        if (expected < 0.4) continue;  // by area
        ++bySolidAngle;
        ASSERT_TRUE(s && t);
        EXPECT_EQ(s->pdf, t->pdf);
        EXPECT_NEAR(1 / s->pdf / expected, 1, 1e-4);
    }
    EXPECT_GT(bySolidAngle, 100);
}

TEST(Sampling, LongRectanglesFromNearTheirEnd) {
    // A tube light 10 by 0.1: by area, the weights of the near end would be 1e4 times the others.
    const Shape shape =
        MakeOne(R"(Shape "bilinearmesh" "point3 P" [ 0 0 0  10 0 0  0 .1 0  10 .1 0 ])");
    const Point3f ref{0.05f, 0.05f, 0.1f};
    const auto a = SampleFrom(shape, 0, ref, {0.1f, 0.5f}),
               b = SampleFrom(shape, 0, ref, {0.9f, 0.5f});
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->pdf, b->pdf);
}

TEST(Sampling, SpheresOfAnySizeFillTheirCone) {
    Rng rng(8);
    for (const float distance : {1.001f, 1.1f, 3.f, 1e2f, 1e4f, 1e6f}) {
        const Shape sphere = Sphere{Transform::Translate({3, 4, 5})};
        const Point3f center{3, 4, 5};
        const Vector3f axis = SampleUniformSphere(rng.Uniform2D());
        const Point3f ref = center + distance * axis;
        const float apart = Length(ref - center);
        double mean = 0;
        const int n = 10000;
        for (int i = 0; i < n; ++i) {
            const auto s = SampleFrom(sphere, 0, ref, rng.Uniform2D());
            ASSERT_TRUE(s);
            EXPECT_NEAR(Length(s->p - center), 1, 1e-5f);
            EXPECT_GT(Dot(s->n, axis), -1e-3f) << "the side that is seen";
            // Uniform in 1 - cos(theta): by the distance from the axis, exact for tiny cones.
            const double across = Length(Cross(ToDouble(s->n), ToDouble(axis)));
            const double along = distance - Dot(s->n, axis);
            const double theta = std::atan2(across, along);
            const double most = std::asin(1 / double(apart));
            mean += Sqr(std::sin(theta / 2) / std::sin(most / 2));
            const double solidAngle = 4 * M_PI * Sqr(std::sin(most / 2));
            EXPECT_NEAR(s->pdf * solidAngle, 1, 1e-4 / (distance - 1) + 1e-5);
        }
        // Uniform on [0, 1]: 5 sigma.
        EXPECT_NEAR(mean / n, 0.5, 5 / std::sqrt(12. * n) + 2e-3) << distance;
    }
}

TEST(Sampling, NormalBoundsTakeTheSideThatVertexNormalsSay) {
    Rng rng(9);
    const std::string triangle = R"(Shape "trianglemesh" "point3 P" [ 0 0 0  2 0 0  0 3 0 ])";
    const std::string patch = R"(Shape "bilinearmesh" "point3 P" [ 0 0 0  2 0 0  0 1 0  2 2 1 ])";
    for (const std::string &text : {triangle + R"( "normal N" [ 0 0 -1  0 0 -1  0 0.1 1 ])",
                                    patch + R"( "normal N" [ 0 0 -1  0 0 -1  0 0 -1  0 0 -1 ])"}) {
        const Shape shape = MakeOne(text);
        const NormalCone cone = NormalBounds(shape, 0);
        EXPECT_NEAR(Length(cone.axis), 1, 1e-5f);
        for (int i = 0; i < 1000; ++i)
            EXPECT_GE(Dot(SampleArea(shape, 0, rng.Uniform2D())->n, cone.axis),
                      cone.cosTheta - 1e-5f)
                << text;
    }
    EXPECT_EQ(NormalBounds(MakeOne(triangle), 0).cosTheta, 1);
    EXPECT_GT(NormalBounds(MakeOne(patch), 0).cosTheta, 0.5f);
}

TEST(Sampling, BoundsAreNoWiderThanTheyMustBe) {
    const Bounds3f b = Bounds(MakeOne("Rotate 30 1 2 3 Translate 1 0 0 Shape \"sphere\""));
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(b.max[k] - b.min[k], 2, 1e-5f);
}

TEST(Sampling, DegenerateOnesGiveNothing) {
    TriangleMesh flat;
    flat.p = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    flat.indices = {0, 1, 2};
    const Shape shape = flat;
    EXPECT_FALSE(SampleArea(shape, 0, {0.3f, 0.6f}));
    EXPECT_FALSE(SampleFrom(shape, 0, {3, 0, 0}, {0.3f, 0.6f}));
    const Shape disk = Disk{};
    EXPECT_FALSE(SampleFrom(disk, 0, {3, 0, 0}, {0.3f, 0.6f})) << "edge-on";
}

}  // namespace
}  // namespace pbrt
