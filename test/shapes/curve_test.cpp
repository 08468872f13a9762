#include <fmt/format.h>

#include "shapes/make.h"

namespace pbrt {
namespace {

CurveSet Curves(std::string_view text) {
    return std::get<CurveSet>(MakeOne(text));
}

/// Points of a uniform B-spline of degree 2 or 3 by the recursion of de Boor.
Point3f DeBoor(std::vector<Point3f> p, int degree, int segment, float u) {
    std::vector<Point3f> d(p.begin() + segment, p.begin() + segment + degree + 1);
    for (int r = 1; r <= degree; ++r)
        for (int j = degree; j >= r; --j) {
            const float a = (u + float(degree - j)) / float(degree - r + 1);
            d[size_t(j)] = Lerp(a, d[size_t(j - 1)], d[size_t(j)]);
        }
    return d[size_t(degree)];
}

const std::vector<Point3f> kPoints{{0, 0, 0}, {1, 2, 0}, {2, -1, 1}, {4, 0, 3}, {5, 2, 2}};
constexpr std::string_view kPointsText = "\"point3 P\" [0 0 0  1 2 0  2 -1 1  4 0 3  5 2 2]";

TEST(Curve, BezierKeepsItsControlPoints) {
    const CurveSet c = Curves(
        "Shape \"curve\" \"point3 P\" [0 0 0 1 0 0 2 1 0 3 1 0 4 1 0 5 0 0 6 0 0] "
        "\"float width0\" 0.4 \"float width1\" 0.1");
    EXPECT_EQ(c.first, (std::vector<uint32_t>{0, 3}));
    ASSERT_EQ(c.points.size(), 7u);
    for (size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(c.points[i].p.x, float(i));
        EXPECT_FLOAT_EQ(c.points[i].radius, Lerp(float(i) / 6, 0.2f, 0.05f));
    }
    EXPECT_EQ(c.type, CurveType::Flat);
}

TEST(Curve, QuadraticsAndBSplinesBecomeCubicBeziers) {
    for (int degree : {2, 3}) {
        const CurveSet c =
            Curves("Shape \"curve\" \"string basis\" \"bspline\" \"integer degree\" " +
                   std::to_string(degree) + " " + std::string(kPointsText));
        ASSERT_EQ(c.first.size(), kPoints.size() - size_t(degree));
        for (int s = 0; s < int(c.first.size()); ++s)
            for (float u : {0.f, 0.3f, 0.5f, 1.f})
                ExpectNear(CurveAt(&c.points[c.first[size_t(s)]], u).p,
                           DeBoor(kPoints, degree, s, u));
    }
    const CurveSet q = Curves("Shape \"curve\" \"integer degree\" 2 " + std::string(kPointsText));
    ASSERT_EQ(q.first.size(), 2u);
    const Point3f middle = 0.25f * kPoints[2] + 0.5f * kPoints[3] + 0.25f * kPoints[4];
    ExpectNear(CurveAt(&q.points[3], 0.5f).p, middle);
}

TEST(Curve, DerivativeIsThatOfThePosition) {
    const CurveSet c =
        Curves(fmt::format("Shape \"curve\" \"string basis\" \"bspline\" {}", kPointsText));
    const float h = 1e-2f;
    for (float u : {0.1f, 0.5f, 0.9f}) {
        const Vector3f slope =
            (CurveAt(&c.points[0], u + h).p - CurveAt(&c.points[0], u - h).p) * (0.5f / h);
        ExpectNear(CurveAt(&c.points[0], u).dpdu, slope, 1e-3f);
    }
}

TEST(Curve, TransformsPlaceAndScale) {
    const CurveSet c = Curves(
        "Rotate 90 0 0 1 Translate 1 0 0 Scale 2 2 2 Shape \"curve\" \"float width\" 0.5 "
        "\"point3 P\" [0 0 0 1 0 0 2 0 0 3 0 0]");
    ExpectNear(c.points[3].p, {0, 7, 0});
    EXPECT_FLOAT_EQ(c.points[3].radius, 0.5f);
}

/// A straight curve along x, radius 0.25, met at height y by a ray along +z.
SurfaceInteraction StraightHit(CurveType type, float y, bool flip = false) {
    CurveSet c;
    for (int i = 0; i < 4; ++i)
        c.points.push_back({{float(i) / 3, 0, 0}, 0.25f});
    c.first = {0};
    c.type = type;
    c.flipNormal = flip;
    return SurfaceAt(Shape(c), HitAt(2, 0.5f, 0), Ray{{0.5f, y, -2}, {0, 0, 1}});
}

/// As in pbrt-v4: v grows to the left of dp/du for one who looks along the ray.
TEST(Curve, FacesTheRayAndIsLeftHanded) {
    for (float y : {-0.2f, 0.f, 0.1f}) {
        for (CurveType type : {CurveType::Flat, CurveType::Cylinder}) {
            const SurfaceInteraction s = StraightHit(type, y);
            ExpectNear(s.n, Normalize(Cross(s.dpdv, s.dpdu)));
            EXPECT_LT(s.n.z, 0);
            EXPECT_FLOAT_EQ(Length(s.dpdv), 0.5f);
            ExpectNear(s.dpdu, {1, 0, 0});
            EXPECT_FLOAT_EQ(s.uv.x, 0.5f);
            // dpdv = y here.
            EXPECT_FLOAT_EQ(s.uv.y, 0.5f + y / 0.5f);
        }
        ExpectNear(StraightHit(CurveType::Flat, y).n, {0, 0, -1});
        ExpectNear(StraightHit(CurveType::Flat, y, true).n, {0, 0, 1});
    }
}

/// A mirrored curve is met where its mirror image is, v and dpdv going along.
TEST(Curve, MirroredByItsTransform) {
    for (const std::string type : {"flat", "cylinder"}) {
        const std::string curve = "Shape \"curve\" \"float width\" 0.5 \"string type\" \"" + type +
                                  "\" \"point3 P\" [0 0 0 1 .2 0 2 0 .3 3 0 0]";
        const Shape straight = MakeOne(curve), mirrored = MakeOne("Scale 1 -1 1 " + curve);
        const auto mirror = [](Vector3f v) { return Vector3f{v.x, -v.y, v.z}; };
        // Within the width: at its edge a cylinder's normal is at right angles to the ray.
        for (float y : {-0.1f, 0.f, 0.2f}) {
            const Ray ray{{0.5f, y, -2}, {0.1f, 0.05f, 1}};
            const SurfaceInteraction a = SurfaceAt(straight, HitAt(2, 0.4f, 0), ray);
            const SurfaceInteraction b =
                SurfaceAt(mirrored, HitAt(2, 0.4f, 0), Ray{mirror(ray.o), mirror(ray.d)});
            EXPECT_EQ(a.uv.x, b.uv.x);
            EXPECT_NEAR(a.uv.y, b.uv.y, 1e-6f);
            ExpectNear(b.n, mirror(a.n));
            ExpectNear(b.dpdu, mirror(a.dpdu));
            ExpectNear(b.dpdv, mirror(a.dpdv));
            EXPECT_LT(Dot(b.n, mirror(ray.d)), 1e-6f);  // 0 at the rim
            ExpectNear(b.ShadingFrame().y, mirror(a.ShadingFrame().y));
        }
    }
}

TEST(Curve, MirroredRibbonKeepsItsOutside) {
    const std::string ribbon =
        "Shape \"curve\" \"string type\" \"ribbon\" \"float width\" 0.5 "
        "\"point3 P\" [0 0 0 1 0 0 2 0 0 3 0 0] \"normal N\" [0 .2 2 0 1 0]";
    const Shape straight = MakeOne(ribbon), mirrored = MakeOne("Scale 1 1 -1 " + ribbon);
    const auto mirror = [](Vector3f v) { return Vector3f{v.x, v.y, -v.z}; };
    for (uint32_t i = 0; i < NPrimitives(straight); ++i) {
        const SurfaceInteraction a = SurfaceAt(straight, HitAt(1, 0.3f, 0.3f, i), Ray{});
        const SurfaceInteraction b = SurfaceAt(mirrored, HitAt(1, 0.3f, 0.3f, i), Ray{});
        EXPECT_EQ(a.uv, b.uv);
        ExpectNear(b.p, mirror(a.p));
        ExpectNear(b.n, mirror(a.n));
        ExpectNear(b.ns, mirror(a.ns));
        ExpectNear(b.dpdv, mirror(a.dpdv));
    }
}

TEST(Curve, CylinderNormalTurnsEvenlyFromEdgeToEdge) {
    for (float v : {0.f, 0.2f, 0.5f, 0.9f, 1.f}) {
        const SurfaceInteraction s = StraightHit(CurveType::Cylinder, 0.25f - 0.5f * v);
        const float angle = (v - 0.5f) * Pi;
        ExpectNear(s.n, {0, -std::sin(angle), -std::cos(angle)}, 1e-5f);
        EXPECT_EQ(s.n, s.ns);
    }
}

TEST(Curve, RibbonHasTheNormalsGiven) {
    const Shape shape = MakeOne(
        "Shape \"curve\" \"string type\" \"ribbon\" \"float width\" 0.5 "
        "\"point3 P\" [0 0 0 1 0 0 2 0 0 3 0 0] \"normal N\" [0 0 2 0 1 0]");
    const auto &mesh = std::get<TriangleMesh>(shape);
    for (size_t i = 0; i < mesh.p.size(); ++i) {
        const float angle = mesh.uv[i].x * Pi / 2;
        ExpectNear(mesh.n[i], {0, std::sin(angle), std::cos(angle)});
        ExpectNear(mesh.p[i], Vector3f{3 * mesh.uv[i].x, 0, 0} +
                                  (0.5f - mesh.uv[i].y) * 0.5f *
                                      Vector3f{0, std::cos(angle), -std::sin(angle)});
    }
    for (uint32_t i = 0; i < mesh.NPrimitives(); ++i) {
        const SurfaceInteraction s = SurfaceAt(shape, HitAt(1, 0.3f, 0.3f, i), Ray{});
        EXPECT_LT(Dot(s.n, Cross(s.dpdu, s.dpdv)), 0);
        EXPECT_GT(Dot(s.n, s.ns), 0.99f);
        EXPECT_GT(Dot(s.dpdu, Vector3f{1, 0, 0}), 2.9f);
    }
}

TEST(Curve, LeavesByAWidthOnTheSideOfTheRay) {
    const SurfaceInteraction s = StraightHit(CurveType::Cylinder, 0.1f);
    for (const float side : {1.f, -1.f}) {
        const Vector3f w = Normalize(side * s.n + Vector3f{0.3f, 0, 0});
        // The ray passes here, a width behind its origin.
        const Vector3f off = s.OffsetOrigin(w) + 0.5f * w - s.p;
        const float expected = 0.5f * (std::abs(s.n.x) + std::abs(s.n.y) + std::abs(s.n.z));
        EXPECT_NEAR(Dot(off, side * s.n), expected, 1e-5f);
        EXPECT_NEAR(Length(off), expected, 1e-5f);
    }
}

TEST(Curve, BoundsHoldThePoints) {
    const Shape c = MakeOne("Shape \"curve\" \"float width\" 0.5 " +
                            std::string("\"point3 P\" [0 0 0 1 2 0 2 -1 1 4 0 3]"));
    const Bounds3f b = Bounds(c);
    for (float u = 0; u <= 1; u += 0.05f) {
        const CurveAt at(std::get<CurveSet>(c).points.data(), u);
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(b.min[k], at.p[k] - at.radius);
            EXPECT_GE(b.max[k], at.p[k] + at.radius);
        }
    }
    EXPECT_FALSE(CanEmit(c));
}

TEST(Curve, AppendedCurvesKeepTheirPoints) {
    const CurveSet a = Curves("Shape \"curve\" \"point3 P\" [0 0 0 1 0 0 2 0 0 3 0 0]");
    CurveSet both = Curves("Shape \"curve\" \"point3 P\" [5 0 0 6 0 0 7 0 0 8 0 0]");
    ASSERT_TRUE(Append(a, &both));
    ASSERT_EQ(both.NPrimitives(), 2u);
    EXPECT_EQ(both.points[both.first[1] + 3].p, a.points[3].p);
    CurveSet round = a;
    round.type = CurveType::Cylinder;
    EXPECT_FALSE(Append(round, &both));
    EXPECT_EQ(both.NPrimitives(), 2u);
}

TEST(Curve, MistakesAreNamed) {
    const auto said = [](const std::string &parameters) {
        const Made made = Make("Shape \"curve\" " + parameters);
        EXPECT_TRUE(made.shapes.empty());
        return made.messages.empty() ? "" : std::string(made.messages[0]);
    };
    EXPECT_NE(said("").find("needs \"point3 P\""), std::string::npos);
    EXPECT_NE(said("\"point3 P\" [0 0 0 1 1 1 2 2 2]").find("3 points; a bezier curve of degree 3"),
              std::string::npos);
    const std::string p = "\"point3 P\" [0 0 0 1 0 0 2 0 0 3 0 0] ";
    EXPECT_NE(said(p + "\"string type\" \"ribbon\"").find("needs 2 normals"), std::string::npos);
    EXPECT_EQ(Make("Scale 1 2 1 Shape \"curve\" " + p).messages.size(), 1u);
    EXPECT_EQ(Make("Shape \"curve\" \"float width\" -1 " + p).messages.size(), 1u);
    EXPECT_EQ(Make("Shape \"curve\" \"string type\" \"round\" " + p).messages.size(), 1u);
}

}  // namespace
}  // namespace pbrt
