// What BuildScene makes of a description.

#include <gtest/gtest.h>

#include "pbrt/build/build_scene.h"

namespace pbrt {
namespace {

TEST(Build, MaterialsThatSayTheSameAreOne) {
    SceneDescription scene;
    Diagnostics log;
    ParseString(R"(WorldBegin
        Material "diffuse" "rgb reflectance" [ .5 .2 .1 ] Shape "sphere"
        Material "diffuse"
            "rgb reflectance" [ .5 .2 .1 ] Shape "sphere"
        Material "diffuse" "rgb reflectance" [ .5 .2 .2 ] Shape "sphere"
        ColorSpace "rec2020"
        Material "diffuse" "rgb reflectance" [ .5 .2 .1 ] Shape "sphere"
        Material "coateddiffuse" "rgb reflectance" [ .5 .2 .1 ] Shape "sphere"
        NamedMaterial "undefined" Shape "sphere")",
                "test.pbrt", "", scene, log);
    ASSERT_EQ(log.ErrorCount(), 1);  // the undefined one
    log = {};
    const std::unique_ptr<RenderScene> world = BuildScene(std::move(scene), {}, log);
    ASSERT_TRUE(world);
    std::vector<int> materials;
    for (const Geometry &g : world->geometries)
        materials.push_back(g.material);
    EXPECT_EQ(materials, (std::vector<int>{1, 1, 2, 3, 4, 0}));  // 0: the default
    EXPECT_EQ(world->materials.Size(), 5u);
}

}  // namespace
}  // namespace pbrt
