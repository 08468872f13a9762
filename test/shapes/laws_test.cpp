// Laws of every type of shape, on the examples in its header.

#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"
#include "shapes/shape_cases.h"

namespace pbrt {
namespace {

template <typename S>
class EveryShape : public testing::Test {};
TYPED_TEST_SUITE(EveryShape, test::TestTypesOf<ShapeTypes>);

#define SKIP_IF_IT_CANNOT_EMIT(S) \
    if constexpr (!S::kTraits.canEmit) GTEST_SKIP() << "cannot emit"

/// Sampled positions at u, and a step to either side of it in x and y; nullopt where one of them
/// lies across a crease of the map.
template <typename F>
std::optional<float> Jacobian(Point2f u, float h, F position) {
    if (std::abs(u.x - u.y) < 3 * h) return {};  // triangles are folded along the diagonal
    const auto a = position(Point2f{u.x - h, u.y}), b = position(Point2f{u.x + h, u.y}),
               c = position(Point2f{u.x, u.y - h}), d = position(Point2f{u.x, u.y + h});
    if (!a || !b || !c || !d) return {};
    return Length(Cross(*b - *a, *d - *c)) / (4 * h * h);
}

Point2f InnerPoint(Rng &rng) {
    const Point2f u = rng.Uniform2D();
    return {0.02f + 0.96f * u.x, 0.02f + 0.96f * u.y};
}

std::vector<Point3f> Viewpoints() {
    Rng rng(2);
    std::vector<Point3f> points{{0.2f, 0.1f, 0.15f}, {0.4f, 0.3f, 3}, {100, -30, 20}};
    for (int i = 0; i < 12; ++i)
        points.push_back(4.f * SampleUniformSphere(rng.Uniform2D()));
    return points;
}

/// f(case, primitive) for every primitive of every example.
template <typename S, typename F>
void ForEachPrimitive(F f) {
    for (const ShapeCase &c : CasesOf<S>())
        for (uint32_t i = 0; i < NPrimitives(c.shape); ++i)
            f(c, i);
}

void ExpectInside(const Bounds3f &b, Point3f p, float slack) {
    for (int k = 0; k < 3; ++k) {
        EXPECT_GE(p[k], b.min[k] - slack);
        EXPECT_LE(p[k], b.max[k] + slack);
    }
}

TYPED_TEST(EveryShape, ExamplesAreOfItsType) {
    for (const ShapeCase &c : CasesOf<TypeParam>())
        EXPECT_TRUE(std::holds_alternative<TypeParam>(c.shape)) << c.text;
}

TYPED_TEST(EveryShape, BoundsHoldThoseOfPrimitives) {
    ForEachPrimitive<TypeParam>([](const ShapeCase &c, uint32_t i) {
        const Bounds3f all = Bounds(c.shape), one = PrimitiveBounds(c.shape, i);
        ASSERT_FALSE(one.Empty()) << c.text;
        ExpectInside(all, one.min, 0);
        ExpectInside(all, one.max, 0);
    });
}

TYPED_TEST(EveryShape, BoundsHoldEverySample) {
    SKIP_IF_IT_CANNOT_EMIT(TypeParam);
    Rng rng(10);
    ForEachPrimitive<TypeParam>([&](const ShapeCase &c, uint32_t primitive) {
        const Bounds3f b = PrimitiveBounds(c.shape, primitive);
        for (int i = 0; i < 1000; ++i)
            ExpectInside(b, SampleArea(c.shape, primitive, rng.Uniform2D())->p, 1e-6f);
    });
}

TYPED_TEST(EveryShape, AreaDensityIsTheInverseJacobian) {
    SKIP_IF_IT_CANNOT_EMIT(TypeParam);
    Rng rng(1);
    ForEachPrimitive<TypeParam>([&](const ShapeCase &c, uint32_t primitive) {
        for (int i = 0; i < 300; ++i) {
            const Point2f u = InnerPoint(rng);
            const auto j = Jacobian(u, 1.f / 1024, [&](Point2f v) -> std::optional<Point3f> {
                return SampleArea(c.shape, primitive, v)->p;
            });
            if (!j) continue;
            // Curvature over the step, where disks shrink to their center, and float's digits.
            EXPECT_NEAR(*j * SampleArea(c.shape, primitive, u)->pdf, 1, 5e-3f) << c.text;
        }
    });
}

TYPED_TEST(EveryShape, MeanInverseAreaDensityIsTheArea) {
    SKIP_IF_IT_CANNOT_EMIT(TypeParam);
    ForEachPrimitive<TypeParam>([](const ShapeCase &c, uint32_t primitive) {
        double sum = 0;
        const int n = 256;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                sum += 1 / SampleArea(c.shape, primitive, {(i + 0.5f) / n, (j + 0.5f) / n})->pdf;
        EXPECT_NEAR(sum / (n * n) / Area(c.shape, primitive), 1, 3e-4) << c.text;
    });
}

TYPED_TEST(EveryShape, SolidAngleDensityIsTheInverseJacobian) {
    SKIP_IF_IT_CANNOT_EMIT(TypeParam);
    Rng rng(3);
    int tested = 0;
    ForEachPrimitive<TypeParam>([&](const ShapeCase &c, uint32_t primitive) {
        for (const Point3f ref : Viewpoints())
            for (int i = 0; i < 40; ++i) {
                const Point2f u = InnerPoint(rng);
                const auto s = SampleFrom(c.shape, primitive, ref, u);
                if (!s) continue;
                const float cosine = AbsDot(s->n, Normalize(s->p - ref));
                if (cosine < 0.1f) continue;  // silhouettes: the map folds
                const auto j = Jacobian(u, 1.f / 256, [&](Point2f v) -> std::optional<Vector3f> {
                    const auto at = SampleFrom(c.shape, primitive, ref, v);
                    if (!at) return {};
                    return Normalize(at->p - ref);
                });
                if (!j) continue;
                // Tiny solid angles lose digits in the differences of directions.
                const float extent = std::sqrt(1 / s->pdf);
                EXPECT_NEAR(*j * s->pdf, 1, 0.03f + 3e-5f / extent) << c.text;
                ++tested;
            }
    });
    EXPECT_GT(tested, 1000 * int(TypeParam::kExamples.size()));
}

TYPED_TEST(EveryShape, PDFFromIsTheSamplersDensity) {
    SKIP_IF_IT_CANNOT_EMIT(TypeParam);
    Rng rng(4);
    ForEachPrimitive<TypeParam>([&](const ShapeCase &c, uint32_t primitive) {
        for (const Point3f ref : Viewpoints())
            for (int i = 0; i < 100; ++i) {
                const auto s = SampleFrom(c.shape, primitive, ref, rng.Uniform2D());
                if (!s) continue;
                const float cosine = AbsDot(s->n, Normalize(s->p - ref));
                const float pdf = PDFFrom(c.shape, primitive, ref, s->p, s->n);
                EXPECT_NEAR(pdf / s->pdf, 1, 1e-4f + 1e-5f / cosine) << c.text;
            }
    });
}

TYPED_TEST(EveryShape, NormalBoundsHoldEveryNormal) {
    SKIP_IF_IT_CANNOT_EMIT(TypeParam);
    Rng rng(9);
    ForEachPrimitive<TypeParam>([&](const ShapeCase &c, uint32_t primitive) {
        const NormalCone cone = NormalBounds(c.shape, primitive);
        EXPECT_NEAR(Length(cone.axis), 1, 1e-5f);
        for (int i = 0; i < 1000; ++i)
            EXPECT_GE(Dot(SampleArea(c.shape, primitive, rng.Uniform2D())->n, cone.axis),
                      cone.cosTheta - 1e-5f)
                << c.text;
    });
}

TYPED_TEST(EveryShape, SampledNormalsTurnWithReverseOrientation) {
    SKIP_IF_IT_CANNOT_EMIT(TypeParam);
    Rng rng(11);
    ForEachPrimitive<TypeParam>([&](const ShapeCase &c, uint32_t primitive) {
        const Shape reversed = MakeOne("ReverseOrientation " + c.text);
        for (int i = 0; i < 50; ++i) {
            const Point2f u = rng.Uniform2D();
            const auto s = SampleArea(c.shape, primitive, u),
                       r = SampleArea(reversed, primitive, u);
            EXPECT_EQ(r->p, s->p);
            EXPECT_EQ(r->n, -s->n) << c.text;
        }
    });
}

}  // namespace
}  // namespace pbrt
