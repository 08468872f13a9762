// What is parsed waits packed: it must come out as it went in, and be small.

#include <gtest/gtest.h>

#include <random>

#include "scene/parse.h"

namespace pbrt {
namespace {

bool Same(const ParsedParameter &a, const ParsedParameter &b) {
    return a.type == b.type && a.name == b.name && a.loc == b.loc && a.valueLoc == b.valueLoc &&
           a.floats == b.floats && a.ints == b.ints && a.strings == b.strings &&
           a.bools == b.bools && a.mayBeUnused == b.mayBeUnused && a.colorSpace == b.colorSpace;
}

bool Same(const ShapeEntity &a, const ShapeEntity &b) {
    return a.type == b.type && a.loc == b.loc && a.colorSpace == b.colorSpace &&
           std::equal(a.params.begin(), a.params.end(), b.params.begin(), b.params.end(),
                      [](const auto &p, const auto &q) { return Same(p, q); }) &&
           a.worldFromObject == b.worldFromObject && a.reverseOrientation == b.reverseOrientation &&
           a.namedMaterial == b.namedMaterial && a.material == b.material &&
           a.areaLight == b.areaLight;
}

/// Shapes with all kinds of content.
class AnyShape {
  public:
    ShapeEntity operator()() {
        ShapeEntity s;
        s.type = std::string(Below(20), 't');
        s.loc = Place();
        s.colorSpace = Space();
        s.params.resize(Below(4));
        for (ParsedParameter &p : s.params)
            Fill(&p);
        const float x = float(Below(2));
        s.worldFromObject = {Transform::Translate({x, 0, 0}),
                             Transform::Translate({x + float(Below(2)), 0, 0})};
        s.reverseOrientation = Below(2);
        s.namedMaterial = Below(2) ? "gold" : "";
        s.material = int(Below(1000)) - 1;
        if (Below(3) == 0) s.areaLight = std::make_shared<Entity>();
        if (Below(3) == 0) s.areaLight = shared;
        return s;
    }

  private:
    size_t Below(size_t n) { return rng() % n; }
    FileLoc Place() {
        constexpr std::array<std::string_view, 3> kFiles{"a.pbrt", "", "included.pbrt"};
        return {kFiles[Below(3)], int(Below(1u << (1 + Below(30)))), int(Below(300))};
    }
    const RGBColorSpace *Space() {
        return Below(2) ? &RGBColorSpace::sRGB() : RGBColorSpace::Named("rec2020");
    }
    void Fill(ParsedParameter *p) {
        p->type = Below(2) ? "float" : "string";
        p->name = std::string(Below(200), 'n');
        p->loc = Place(), p->valueLoc = Place();
        p->mayBeUnused = Below(2);
        p->colorSpace = Below(3) ? Space() : nullptr;
        const size_t kind = Below(5), count = 1 + Below(300);
        if (kind == 0) p->floats.assign(count, -0.f);
        if (kind == 1) p->ints.assign(count, -7);
        if (kind == 2) p->strings.assign(count, std::string(Below(3) * 70, 's'));
        if (kind == 3) p->bools.assign(count, 1);
    }

    std::mt19937 rng{1};
    std::shared_ptr<const Entity> shared = std::make_shared<Entity>();
};

TEST(PackedEntities, GivesBackWhatWasAppended) {
    AnyShape any;
    PackedEntities<ShapeEntity> queue;
    std::deque<ShapeEntity> expected;
    for (int i = 0; i < 10000; ++i) {  // some 7 MB
        expected.push_back(any());
        queue.Append(expected.back());
        if (i % 4 != 0) continue;
        ASSERT_TRUE(Same(queue.Take(), expected.front())) << i;
        expected.pop_front();
    }
    ASSERT_EQ(queue.size(), expected.size());
    for (size_t walk = 0; walk < 2; ++walk) {  // reading leaves it as it is
        auto e = expected.begin();
        for (const ShapeEntity &s : queue)
            ASSERT_TRUE(Same(s, *e++));
        EXPECT_EQ(e, expected.end());
    }
    for (const ShapeEntity &s : expected)
        ASSERT_TRUE(Same(queue.Take(), s));
    EXPECT_TRUE(queue.empty());
    EXPECT_EQ(queue.Bytes(), 0u);
}

TEST(PackedEntities, InstancesKeepTheirTransforms) {
    const Transform turned = *Transform::Rotate(40, {1, 2, 3}) * Transform::Translate({1, 2, 3});
    const Transform perspective = Transform::Perspective(40, 1, 100);
    PackedEntities<InstanceUse> queue;
    std::vector<InstanceUse> expected;
    for (const TransformPair &t : std::initializer_list<TransformPair>{
             {turned, turned}, {Transform(), turned}, {perspective, perspective}})
        for (const char *name : {"leaf", ""})
            queue.Append(expected.emplace_back(InstanceUse{name, {"a.pbrt", 7, 3}, t}));
    const std::vector<InstanceUse> got = All(queue);
    ASSERT_EQ(got.size(), expected.size());
    for (size_t i = 0; i < got.size(); ++i) {
        EXPECT_EQ(got[i].name, expected[i].name);
        EXPECT_EQ(got[i].loc, expected[i].loc);
        EXPECT_EQ(got[i].worldFromInstance, expected[i].worldFromInstance);
    }
    PackedEntities<InstanceUse> many;
    for (int i = 0; i < 1000; ++i)
        many.Append(expected[0]);
    EXPECT_LT(many.Bytes(), 1000 * (24 * sizeof(float) + 16));
}

TEST(PackedEntities, ShapesAreSmallerThanTheirText) {
    const std::string sphere = "Shape \"sphere\" \"float radius\" 0.001\n";
    const std::string curve =
        "Shape \"curve\" \"string type\" \"cylinder\" \"string basis\" \"bspline\" \"point3 P\" "
        "[ 0.01 0.02 0.03 0.04 0.05 0.06 0.07 0.08 0.09 0.10 0.11 0.12 ] "
        "\"float width0\" 0.004 \"float width1\" 0.002\n";
    const std::string material = "Material \"diffuse\" \"rgb reflectance\" [ 0.5 0.25 0.125 ]\n";
    for (const std::string &text : {sphere, curve, material}) {
        constexpr size_t kCount = 1000;
        std::string all;
        for (size_t i = 0; i < kCount; ++i)
            all += text;
        const auto parsed = ParseWorld(all);
        const SceneDescription &d = parsed->scene;
        ASSERT_EQ(d.shapes.size() + d.materials.size(), kCount);
        EXPECT_LT(d.shapes.Bytes() + d.materials.Bytes(), kCount * (text.size() + 8)) << text;
    }
}

}  // namespace
}  // namespace pbrt
