// Numbers that fit into a float, but into none of the integers that are made of them.

#include "faults/faults.h"

namespace pbrt::test {
namespace {

class Values : public Faults {
  protected:
    /// The picture of a scene that renders.
    std::string Picture() const {
        const Outcome outcome = Render();
        EXPECT_EQ(outcome.exitCode, 0) << outcome.said;
        return Get("out.pfm");
    }
};

TEST_F(Values, CropWindowsBeyondThePictureAreClipped) {
    const auto withCrop = [&](const std::string &window) {
        PutScene("Shape \"sphere\"");
        const std::string text = Get("scene.pbrt"), film = "\"integer yresolution\" 16";
        Put("scene.pbrt", std::string(text).insert(text.find(film) + film.size(),
                                                   " \"float cropwindow\" [" + window + "]"));
    };
    withCrop("0 1 0 1");
    const std::string whole = Picture();
    for (const char *window : {"-1e30 1e30 0 1", "-3e38 3e38 -3e38 3e38", "-1 2 -1e10 1e10"}) {
        withCrop(window);
        EXPECT_TRUE(Picture() == whole) << window;
    }
    for (const char *window : {"1e30 -1e30 0 1", "1e30 2e30 0 1", "-2e30 -1e30 0 1"}) {
        withCrop(window);
        EXPECT_TRUE(Refused(Render(), "no pixels are left")) << window;
    }
}

TEST_F(Values, LightsAndTexturesAtTheEndOfTheFloats) {
    std::string lights;
    for (const char *at : {"3e38 0 0", "-3e38 0 0", "0 3e38 0", "0 0 2"})
        lights += std::string("LightSource \"point\" \"point3 from\" [") + at + "]\n";
    PutScene(lights + "Shape \"sphere\"");
    EXPECT_TRUE(Ended(Render()));
    PutScene(
        "Texture \"t\" \"spectrum\" \"checkerboard\" \"float uscale\" 3e38\n"
        "Material \"diffuse\" \"texture reflectance\" \"t\"\nShape \"sphere\"");
    EXPECT_TRUE(Ended(Render()));
}

}  // namespace
}  // namespace pbrt::test
