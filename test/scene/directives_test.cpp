// What each directive puts into the SceneDescription.

#include <gtest/gtest.h>

#include "scene/parse.h"

namespace pbrt {
namespace {

TEST(Directives, SettingsOfThePictureLastOneWins) {
    const auto parsed = Parse(R"(
        Accelerator "bvh" "integer maxnodeprims" 2
        Camera "perspective" "float fov" 40   Film "rgb"
        Integrator "path"  PixelFilter "box"  Sampler "halton" "integer pixelsamples" 1
        Sampler "zsobol"
        WorldBegin)");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const SceneDescription &d = parsed->scene;
    EXPECT_EQ(d.accelerator.type, "bvh");
    EXPECT_EQ(d.accelerator.params.at(0).ints, std::vector<int>{2});
    EXPECT_EQ(d.camera.type, "perspective");
    EXPECT_EQ(d.camera.loc, (FileLoc{"test.pbrt", 3, 9}));
    EXPECT_EQ(d.film.type, "rgb");
    EXPECT_EQ(d.integrator.type, "path");
    EXPECT_EQ(d.filter.type, "box");
    EXPECT_EQ(d.sampler.type, "zsobol");
    EXPECT_TRUE(d.sampler.params.empty());
}

TEST(Directives, WhatIsNotGivenHasNoType) {
    const auto parsed = Parse("WorldBegin");
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(parsed->scene.film.type, "");
    EXPECT_EQ(parsed->scene.camera.type, "");
    EXPECT_EQ(parsed->scene.transformStart, 0);
    EXPECT_EQ(parsed->scene.transformEnd, 1);
    EXPECT_TRUE(parsed->scene.cameraFromWorld[0] == Transform());
}

TEST(Directives, MaterialsAreCurrentUntilTheNext) {
    const auto parsed = ParseWorld(R"(
        Shape "a"
        Material "diffuse"      Shape "b"
        Material "conductor"    Shape "c"
        NamedMaterial "gold"    Shape "d"
        Material "dielectric"   Shape "e"
        MakeNamedMaterial "gold" "float roughness" 0.1 "string type" "conductor")");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const SceneDescription &d = parsed->scene;
    const std::vector<int> expected{-1, 0, 1, -1, 2};
    ASSERT_EQ(d.shapes.size(), 5u);
    for (size_t i = 0; i < 5; ++i)
        EXPECT_EQ(All(d.shapes)[i].material, expected[i]) << i;
    EXPECT_EQ(All(d.shapes)[3].namedMaterial, "gold");
    EXPECT_EQ(All(d.shapes)[4].namedMaterial, "");
    ASSERT_EQ(d.materials.size(), 3u);
    EXPECT_EQ(All(d.materials)[2].type, "dielectric");
    ASSERT_EQ(d.namedMaterials.size(), 1u);
    EXPECT_EQ(d.namedMaterials[0].name, "gold");
    EXPECT_EQ(d.namedMaterials[0].type, "conductor");
    ASSERT_EQ(d.namedMaterials[0].params.size(), 1u);  // "type" is taken out
    EXPECT_EQ(d.namedMaterials[0].params[0].name, "roughness");
}

TEST(Directives, AreaLightsShineUntilTheScopeEnds) {
    const auto parsed = ParseWorld(R"(
        AttributeBegin
            AreaLightSource "diffuse" "float scale" 2
            Shape "a" Shape "b"
        AttributeEnd
        Shape "c")");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const auto shapes = All(parsed->scene.shapes);
    ASSERT_TRUE(shapes.at(0).areaLight);
    EXPECT_EQ(shapes[0].areaLight->type, "diffuse");
    EXPECT_EQ(shapes[0].areaLight->params.at(0).name, "scale");
    EXPECT_EQ(shapes[0].areaLight, shapes.at(1).areaLight);
    EXPECT_FALSE(shapes.at(2).areaLight);
}

TEST(Directives, TexturesAndLightsKeepTheirTransform) {
    const auto parsed = ParseWorld(R"(
        Translate 1 2 3
        Texture "t" "float" "constant" "float value" 2
        Texture "t" "spectrum" "marble"
        LightSource "point" "float power" 3)");
    EXPECT_EQ(parsed->Messages(), Texts{});  // the two kinds have names of their own
    const auto &textures = parsed->scene.textures;
    ASSERT_EQ(textures.size(), 2u);
    EXPECT_EQ(textures[0].name, "t");
    EXPECT_TRUE(textures[0].isFloat);
    EXPECT_EQ(textures[0].type, "constant");
    EXPECT_FALSE(textures[1].isFloat);
    const Transform t = Transform::Translate({1, 2, 3});
    EXPECT_EQ(textures[0].worldFromTexture, t);
    EXPECT_EQ(parsed->scene.lights.at(0).worldFromLight, t);
    EXPECT_EQ(parsed->scene.lights[0].type, "point");
}

TEST(Directives, ColorSpaceIsScopedAndKeptByParameters) {
    const auto parsed = ParseWorld(R"(
        ColorSpace "rec2020"
        Attribute "material" "rgb reflectance" [ 1 0 0 ]
        AttributeBegin
            ColorSpace "ACES2065-1"
            Material "diffuse" "rgb x" [ 0 0 0 ]
        AttributeEnd
        Material "diffuse")");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const RGBColorSpace *rec2020 = RGBColorSpace::Named("rec2020");
    const RGBColorSpace *aces = RGBColorSpace::Named("aces2065-1");
    const auto m = All(parsed->scene.materials);
    EXPECT_EQ(m.at(0).colorSpace, aces);
    EXPECT_EQ(m[0].params.at(0).colorSpace, aces);
    EXPECT_EQ(m[0].params.at(1).colorSpace, rec2020);  // of the Attribute directive
    EXPECT_EQ(m.at(1).colorSpace, rec2020);
    EXPECT_EQ(Parse("Film \"rgb\" WorldBegin")->scene.film.colorSpace, &RGBColorSpace::sRGB());
}

TEST(Directives, ObjectsHoldShapesAndInstancesUseThem) {
    const auto parsed = ParseWorld(R"(
        ObjectInstance "tree"
        ObjectBegin "tree"
            Translate 1 0 0
            Material "diffuse"
            Shape "trunk"
            ObjectInstance "leaf"
        ObjectEnd
        ObjectBegin "leaf"  Shape "disk"  ObjectEnd
        Scale 2 2 2
        ObjectInstance "tree"
        Shape "ground")");
    EXPECT_EQ(parsed->Messages(), Texts{});
    const SceneDescription &d = parsed->scene;
    ASSERT_EQ(d.shapes.size(), 1u);
    EXPECT_EQ(All(d.shapes)[0].material, -1);  // ObjectEnd restores the state
    ASSERT_EQ(d.objects.size(), 2u);
    const ObjectEntity &tree = d.objects.at("tree");
    ASSERT_EQ(tree.shapes.size(), 1u);
    EXPECT_EQ(All(tree.shapes)[0].worldFromObject[0], Transform::Translate({1, 0, 0}));
    ASSERT_EQ(tree.instances.size(), 1u);
    EXPECT_EQ(All(tree.instances)[0].worldFromInstance[0], Transform::Translate({1, 0, 0}));
    ASSERT_EQ(d.instances.size(), 2u);
    EXPECT_TRUE(All(d.instances)[0].worldFromInstance[0] == Transform());
    EXPECT_EQ(All(d.instances)[1].worldFromInstance[0], *Transform::Scale({2, 2, 2}));
}

TEST(Directives, AreaLightsInObjectsAreDroppedWithAWarning) {
    const auto parsed = ParseWorld(
        "ObjectBegin \"o\" AreaLightSource \"diffuse\"\nShape \"a\" "
        "ObjectEnd");
    EXPECT_EQ(parsed->Messages(), Texts{"test.pbrt:3:1: area lights are not instanced: this shape "
                                        "of an object does not shine"});
    EXPECT_FALSE(parsed->log.HasErrors());
    EXPECT_FALSE(All(parsed->scene.objects.at("o").shapes).at(0).areaLight);
}

TEST(Directives, VacuumInterfacesAreHarmlessAndMediaAreNot) {
    EXPECT_EQ(ParseWorld("MediumInterface \"\" \"\" MediumInterface \"\" Shape \"a\"")->Messages(),
              Texts{});
    // A medium is refused where it is made, before or after its uses.
    const std::string fog = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"";
    for (const std::string &text : {"MediumInterface \"\" \"fog\" MediumInterface \"fog\"\n" + fog,
                                    "\n" + fog + " MediumInterface \"fog\" \"fog\""})
        EXPECT_EQ(
            ParseWorld(text)->Messages(),
            Texts{"test.pbrt:3:1: medium \"fog\" (\"homogeneous\"): pbrt-v4 has it; not built "
                  "here. Only surfaces are rendered: take out medium and MediumInterface"});
    EXPECT_EQ(ParseWorld("MakeNamedMedium \"fog\" \"float g\" 1")->Messages(),
              Texts{"test.pbrt:2:1: medium \"fog\" is of no type that pbrt-v4 has (\"string "
                    "type\"), and only surfaces are rendered here"});
    EXPECT_EQ(ParseWorld("MediumInterface \"fog\" \"\"")->Messages(),
              Texts{"test.pbrt:2:17: medium \"fog\" is not defined"});
}

TEST(Directives, OptionsAreSet) {
    auto parsed = std::make_unique<Parsed>();
    parsed->scene.options.seed = 3;
    parsed->scene.options.forceDiffuse = true;
    ParseString(R"(Option "disable_pixel-jitter" true  Option "DisableWavelengthJitter" true
                   Option "forcediffuse" false          Option "seed" 17
                   Option "mse-reference-image" "a.exr" Option "msereferenceout" "b.txt"
                   Option "rendercoordsys" "world"      WorldBegin)",
                "test.pbrt", "", parsed->scene, parsed->log);
    EXPECT_EQ(parsed->Messages(), Texts{});
    const Options &o = parsed->scene.options;
    EXPECT_TRUE(o.disablePixelJitter);
    EXPECT_TRUE(o.disableWavelengthJitter);
    EXPECT_FALSE(o.disableTextureFiltering);
    EXPECT_FALSE(o.forceDiffuse);
    EXPECT_EQ(o.seed, 17);
    EXPECT_EQ(o.mseReferenceImage, "a.exr");
    EXPECT_EQ(o.mseReferenceOut, "b.txt");
    EXPECT_EQ(o.renderCoordSys, "world");
}

TEST(Directives, OptionsWithoutMeaningHereAreWarnings) {
    const auto parsed = Parse(
        "Option \"wavefront\" true Option \"displacementedgescale\" 2 "
        "WorldBegin");
    EXPECT_EQ(parsed->Messages(),
              (Texts{"test.pbrt:1:8: Option: \"wavefront\" has no effect in this renderer",
                     "test.pbrt:1:32: Option: \"displacementedgescale\" has no effect in this "
                     "renderer"}));
    EXPECT_FALSE(parsed->log.HasErrors());
}

TEST(Directives, TransformTimesAreKept) {
    const auto parsed = Parse("TransformTimes 0.25 2 WorldBegin");
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(parsed->scene.transformStart, .25f);
    EXPECT_EQ(parsed->scene.transformEnd, 2);
}

TEST(Directives, WhatIsUndefinedIsReportedOnceAndLeftOut) {
    const auto parsed = ParseWorld(R"(NamedMaterial "none" Shape "a" Shape "b"
        ObjectBegin "o" ObjectInstance "o" ObjectInstance "missing" Shape "c" ObjectEnd
        ObjectInstance "missing" ObjectInstance "o"
        MakeNamedMaterial "typeless" NamedMaterial "typeless" Shape "d")");
    EXPECT_EQ(parsed->Messages(),
              (Texts{"test.pbrt:5:9: material \"typeless\" lacks its \"string type\"",
                     "test.pbrt:2:1: material \"none\" is not defined",
                     "test.pbrt:4:9: object \"missing\" is not defined",
                     "test.pbrt:3:25: object \"o\" contains itself"}));
    const SceneDescription &d = parsed->scene;
    EXPECT_TRUE(d.objects.at("o").instances.empty());
    ASSERT_EQ(d.instances.size(), 1u);
    EXPECT_EQ(All(d.instances)[0].name, "o");
}

TEST(Directives, AnUnknownOneIsPassedOverWithItsArguments) {
    const auto parsed = ParseWorld("Foo bar \"x\" [ 1 2 ] baz\nbar 1 Shape \"a\"\n[ qux\nquux ]");
    EXPECT_EQ(parsed->Messages(), (Texts{"test.pbrt:2:1: unknown directive \"Foo\"",
                                         "test.pbrt:3:1: unknown directive \"bar\"",
                                         "test.pbrt:4:1: expected a directive, found \"[\""}));
    EXPECT_EQ(parsed->scene.shapes.size(), 1u);
}

TEST(Directives, HopelessFilesAreGivenUp) {
    std::string text;
    for (int i = 0; i < 1000; ++i)
        text += "Oops" + std::to_string(i) + "\n";
    const auto parsed = ParseWorld(text);
    EXPECT_EQ(parsed->log.ErrorCount(), 201);
    EXPECT_EQ(parsed->Messages().back(), "test.pbrt: 200 errors; reading stopped at line 202");
}

TEST(Directives, EverythingMayStandOnOneLine) {
    const auto parsed = Parse(
        "Camera\"perspective\"\"float fov\"[40]WorldBegin Shape\"sphere\"Translate 1 2 3 "
        "Shape\"a\"");
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(parsed->scene.shapes.size(), 2u);
}

}  // namespace
}  // namespace pbrt
