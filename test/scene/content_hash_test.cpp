#include "pbrt/scene/content_hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "pbrt/scene/description.h"

namespace pbrt {
namespace {

ContentHash HashOf(const std::string &material) {
    SceneDescription scene;
    Diagnostics log;
    ParseString("WorldBegin\n" + material, "test", ".", scene, log);
    EXPECT_FALSE(log.HasErrors()) << material;
    return HashContent(scene.materials.Take());
}

TEST(ContentHash, PlacesDoNotCount) {
    EXPECT_EQ(HashOf("Material \"diffuse\" \"rgb reflectance\" [ .1 .2 .3 ]"),
              HashOf("\n\n  Material   \"diffuse\"\n\"rgb reflectance\" [ .1 .2\n.3 ]"));
}

TEST(ContentHash, AllElseCounts) {
    const char *const materials[] = {
        "Material \"diffuse\"",
        "Material \"conductor\"",
        "Material \"diffuse\" \"rgb reflectance\" [ .1 .2 .3 ]",
        "Material \"diffuse\" \"rgb reflectance\" [ .1 .2 .4 ]",
        "Material \"diffuse\" \"rgb transmittance\" [ .1 .2 .3 ]",
        "Material \"diffuse\" \"float reflectance\" [ .1 .2 .3 ]",
        "Material \"diffuse\" \"float reflectance\" [ .1 .2 ]",
        "Material \"diffuse\" \"float reflectance\" 0",
        "Material \"diffuse\" \"float reflectance\" -0",
        "Material \"diffuse\" \"integer reflectance\" 0",
        "Material \"diffuse\" \"bool reflectance\" false",
        "Material \"diffuse\" \"string reflectance\" \"ab\"",
        "Material \"diffuse\" \"string reflectance\" [ \"a\" \"b\" ]",
        "Material \"diffuse\" \"texture reflectance\" \"ab\"",
        "ColorSpace \"rec2020\" Material \"diffuse\"",
        "ColorSpace \"rec2020\" Material \"diffuse\" \"rgb reflectance\" [ .1 .2 .3 ]",
        "Attribute \"material\" \"rgb reflectance\" [ .1 .2 .3 ] Material \"diffuse\"",
    };
    std::set<ContentHash> hashes;
    for (const char *material : materials)
        EXPECT_TRUE(hashes.insert(HashOf(material)).second) << material;
}

}  // namespace
}  // namespace pbrt
