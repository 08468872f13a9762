// Measurements in files as materials take them.

#include <cmath>

#include "materials/material_text.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

class Measured : public TempFolder {
  protected:
    /// `list` names the file "m.txt", which holds `file`.
    MaterialText Made(const std::string &list, const std::string &file) const {
        Put("m.txt", file);
        return MaterialText("Material " + list + " \"" + Path("m.txt") + "\"");
    }
};

TEST_F(Measured, IndexAndPigmentOfASpectrometerAreTaken) {
    for (const std::string name : {"eta", "melanin"}) {
        const std::string value = name == "eta" ? "1.56" : "0.1";
        const MaterialText m = Made("\"featherbarbule\" \"spectrum " + name + "\"",
                                    "300 " + value + "\n500 " + value + "\n700 " + value + "\n");
        EXPECT_FALSE(m.log.HasErrors()) << m.Messages();
        ASSERT_EQ(m.log.Messages().size(), 1u);
        EXPECT_NE(m.Messages().find("m.txt\" covers 300 to 700 nm of 360 to 830"),
                  std::string::npos)
            << m.Messages();
        const auto &feather = std::get<FeatherBarbuleMaterial>(*m.material);
        const auto lambda = SampledWavelengths::Of({400, 600, 701, 829});
        const FeatherSurface surface = feather.GetPacketInput({}, lambda);
        for (int i = 0; i < NSpectrumSamples; ++i)
            EXPECT_FLOAT_EQ(name == "eta" ? surface.optics.eta[i] : surface.optics.melanin[i],
                            std::stof(value));
    }
}

TEST_F(Measured, MetalsKeepTheirEnds) {
    Put("k.txt", "400 3\n700 5\n");
    const MaterialText m("Material \"conductor\" \"spectrum k\" \"" + Path("k.txt") + "\"");
    ASSERT_EQ(m.log.Messages().size(), 1u);
    const auto &k = std::get<ConductorMaterial>(*m.material).k;
    const auto lambda = SampledWavelengths::Of({361, 399, 701, 829});
    // Between two equal values: three roundings, two where they are fused.
    EXPECT_FLOAT_EQ(k.Evaluate({}, lambda)[0], 3);
    EXPECT_FLOAT_EQ(k.Evaluate({}, lambda)[3], 5);
}

TEST_F(Measured, TexturesWarnOnceAsWell) {
    Put("r.txt", "400 .3\n700 .5\n");
    const MaterialText m("Texture \"t\" \"spectrum\" \"constant\" \"spectrum value\" \"" +
                         Path("r.txt") + "\"\nMaterial \"diffuse\" \"texture reflectance\" \"t\"");
    EXPECT_EQ(m.log.Messages().size(), 1u);
    const auto lambda = SampledWavelengths::Of({361, 399, 701, 829});
    EXPECT_FLOAT_EQ(std::get<DiffuseMaterial>(*m.material).reflectance.Evaluate({}, lambda)[3],
                    0.5f);
}

TEST_F(Measured, PercentAndMicrometresAreGuessed) {
    EXPECT_NE(Made("\"featherbarbule\" \"spectrum melanin\"", "300 8.6\n900 12\n")
                  .Messages()
                  .find("outside [0, 1]; is this in percent?"),
              std::string::npos);
    EXPECT_NE(Made("\"featherbarbule\" \"spectrum eta\"", "0.3 1.5\n0.7 1.6\n")
                  .Messages()
                  .find("are these micrometres?"),
              std::string::npos);
}

TEST(InlineSpectra, AreZeroOutsideTheirWavelengths) {
    const MaterialText m("Material \"featherbarbule\" \"spectrum eta\" [ 300 1.5 700 1.5 ]");
    EXPECT_EQ(m.Messages(),
              "t.pbrt:2:27: \"eta\" is 0 at 701 nm, outside [1, 1000]; spectra that stand in the "
              "scene are 0 outside their wavelengths\n");
}

}  // namespace
}  // namespace pbrt::test
