// Colours and spectra read through ParamDict.

#include <gtest/gtest.h>

#include <fstream>

#include "scene/parse.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

constexpr SpectrumParam Row(SpectrumType role) {
    return {"s", role, "0.5", "a spectrum"};
}

struct Read {
    std::optional<Spectrum> spectrum;
    Texts messages;
};

/// What `"... s" ...` on line 2 gives, with sRGB current.
Read ReadSpectrum(const std::string &list, SpectrumType role = SpectrumType::Unbounded,
                  const std::string &dir = "") {
    const auto parsed = ParseWorld(list.empty() ? "" : "LightSource \"l\" " + list);
    const Entity &l = parsed->scene.lights.at(0);
    ParamDict d(l.params, l.loc, "light \"l\"", l.colorSpace, &parsed->log, dir);
    Read result;
    result.spectrum = d.GetOneSpectrum(Row(role));
    d.ReportUnused();
    result.messages = parsed->Messages();
    return result;
}

void ExpectSame(const Spectrum &a, const Spectrum &b) {
    for (float lambda = 360; lambda <= 830; lambda += 5)
        EXPECT_EQ(a(lambda), b(lambda)) << lambda;
}

TEST(ParamSpectrum, DefaultsAreNumbersOrNames) {
    ExpectSame(DefaultSpectrum(Row(SpectrumType::Albedo)), Spectrum(0.5f));
    ExpectSame(DefaultSpectrum({"k", SpectrumType::Unbounded, "metal-Cu-k", ""}),
               *GetNamedSpectrum("metal-Cu-k"));
}

TEST(ParamSpectrum, RgbTakesItsRole) {
    const std::string rgb = "\"rgb s\" [ 0.2 0.5 0.9 ]";
    const RGB c{.2f, .5f, .9f};
    const RGBColorSpace &space = RGBColorSpace::sRGB();
    ExpectSame(*ReadSpectrum(rgb, SpectrumType::Albedo).spectrum, space.AlbedoSpectrum(c));
    ExpectSame(*ReadSpectrum(rgb, SpectrumType::Unbounded).spectrum, space.UnboundedSpectrum(c));
    ExpectSame(*ReadSpectrum(rgb, SpectrumType::Illuminant).spectrum, space.IlluminantSpectrum(c));
}

TEST(ParamSpectrum, RgbUsesTheColorSpaceOfItsDirective) {
    const auto parsed = ParseWorld(
        "ColorSpace \"rec2020\" Attribute \"light\" \"rgb s\" [ 1 0 0 ] "
        "ColorSpace \"srgb\" LightSource \"l\"");
    const Entity &l = parsed->scene.lights.at(0);
    ParamDict d(l.params, l.loc, "light \"l\"", l.colorSpace, &parsed->log);
    ExpectSame(*d.GetOneSpectrum(Row(SpectrumType::Illuminant)),
               RGBColorSpace::Named("rec2020")->IlluminantSpectrum({1, 0, 0}));
}

TEST(ParamSpectrum, RgbRanges) {
    EXPECT_TRUE(ReadSpectrum("\"rgb s\" [ 0 1 7 ]", SpectrumType::Unbounded).spectrum);
    EXPECT_TRUE(ReadSpectrum("\"rgb s\" [ 0 1 7 ]", SpectrumType::Illuminant).spectrum);
    EXPECT_TRUE(ReadSpectrum("\"rgb s\" [ 0 1 1 ]", SpectrumType::Albedo).spectrum);
    const Read large = ReadSpectrum("\"rgb s\" [ 0 1 1.5 ]", SpectrumType::Albedo);
    EXPECT_FALSE(large.spectrum);
    EXPECT_EQ(large.messages, Texts{R"(test.pbrt:2:27: "rgb s": 1.5 is outside [0, 1])"});
    const Read negative = ReadSpectrum("\"rgb s\" [ 0 -1 0 ]", SpectrumType::Illuminant);
    EXPECT_FALSE(negative.spectrum);
    EXPECT_EQ(negative.messages, Texts{R"(test.pbrt:2:27: "rgb s": -1 is less than 0)"});
    EXPECT_EQ(ReadSpectrum("\"rgb s\" [ 0 1 ]").messages,
              Texts{R"(test.pbrt:2:27: "rgb s": expected 3 values, found 2)"});
}

TEST(ParamSpectrum, Blackbody) {
    ExpectSame(*ReadSpectrum("\"blackbody s\" 3000").spectrum, Spectrum::Blackbody(3000));
    EXPECT_EQ(ReadSpectrum("\"blackbody s\" 0").messages,
              Texts{R"(test.pbrt:2:31: "blackbody s": 0 is not above 0 K)"});
    EXPECT_EQ(ReadSpectrum("\"blackbody s\" [ 3000 1 ]").messages,
              Texts{R"(test.pbrt:2:33: "blackbody s": expected 1 value, found 2)"});
}

TEST(ParamSpectrum, InlinePairs) {
    const Read pairs = ReadSpectrum("\"spectrum s\" [ 400 1 500 3 ]");
    EXPECT_EQ(pairs.messages, Texts{});
    EXPECT_EQ((*pairs.spectrum)(450), 2);
    EXPECT_EQ((*pairs.spectrum)(501), 0);
    EXPECT_EQ(
        ReadSpectrum("\"spectrum s\" [ 400 1 500 ]").messages,
        Texts{R"(test.pbrt:2:32: "spectrum s": 3 numbers are not pairs of wavelength and value)"});
    EXPECT_EQ(ReadSpectrum("\"spectrum s\" [ 400 1 400 2 ]").messages,
              Texts{R"(test.pbrt:2:32: "spectrum s": wavelength 400 nm follows 400 nm; they must )"
                    "increase"});
    const Read one = ReadSpectrum("\"spectrum s\" [ 400 1 ]");
    EXPECT_TRUE(one.spectrum);
    EXPECT_EQ(one.messages, Texts{R"(test.pbrt:2:32: "spectrum s": one wavelength only; the )"
                                  "spectrum is 0 at all others"});
}

class ParamSpectrumFile : public TempFolder {
  protected:
    void Write(const std::string &name, const std::string &text) {
        std::ofstream(Path(name)) << text;
    }
};

TEST_F(ParamSpectrumFile, NamesComeBeforeFiles) {
    Write("metal-Cu-k", "400 7\n500 7\n");
    Write("mine.spd", "# my own\n400 1\n500 3\n");
    const Read named =
        ReadSpectrum("\"spectrum s\" \"metal-Cu-k\"", SpectrumType::Unbounded, folder.string());
    ExpectSame(*named.spectrum, *GetNamedSpectrum("metal-Cu-k"));
    const Read file =
        ReadSpectrum("\"spectrum s\" \"mine.spd\"", SpectrumType::Unbounded, folder.string());
    EXPECT_EQ((*file.spectrum)(450), 2);
}

TEST_F(ParamSpectrumFile, MeasurementsKeepTheirEndsOnSurfacesOnly) {
    Write("mine.spd", "400 1\n700 3\n");
    for (const SpectrumType role :
         {SpectrumType::Albedo, SpectrumType::Unbounded, SpectrumType::Illuminant}) {
        const Read read = ReadSpectrum("\"spectrum s\" \"mine.spd\"", role, folder.string());
        const bool isLight = role == SpectrumType::Illuminant;
        for (const float lambda : {360.f, 399.f})
            EXPECT_EQ((*read.spectrum)(lambda), isLight ? 0 : 1) << lambda;
        for (const float lambda : {701.f, 830.f})
            EXPECT_EQ((*read.spectrum)(lambda), isLight ? 0 : 3) << lambda;
        EXPECT_EQ((*read.spectrum)(550), 2);
        EXPECT_EQ(read.messages,
                  Texts{"test.pbrt:2:30: \"mine.spd\" covers 400 to 700 nm of 360 to "
                        "830: outside, surfaces have its end values and lights are "
                        "dark"});
    }
}

TEST_F(ParamSpectrumFile, AShortOneIsWarnedOfOnce) {
    Write("mine.spd", "400 1\n700 3\n");
    const auto parsed = ParseWorld(
        "LightSource \"l\" \"spectrum s\" \"mine.spd\" "
        "LightSource \"l\" \"spectrum s\" \"mine.spd\"");
    for (const Entity &l : parsed->scene.lights)
        for (const SpectrumType role : {SpectrumType::Albedo, SpectrumType::Illuminant}) {
            ParamDict d(l.params, l.loc, "light \"l\"", l.colorSpace, &parsed->log,
                        folder.string());
            EXPECT_TRUE(d.GetOneSpectrum(Row(role)));
        }
    EXPECT_EQ(parsed->Messages().size(), 1u);
}

TEST_F(ParamSpectrumFile, NothingIsSaidWhereNothingIsMissing) {
    const auto said = [&](const std::string &text) {
        Write("mine.spd", text);
        return ReadSpectrum("\"spectrum s\" \"mine.spd\"", SpectrumType::Albedo, folder.string())
            .messages;
    };
    EXPECT_EQ(said("360 1 830 1"), Texts{});
    EXPECT_EQ(said("300 1 900 1"), Texts{});
    EXPECT_EQ(said("400 0 500 1 600 0"), Texts{});
    EXPECT_EQ(said("300 1 829 1").size(), 1u);
    EXPECT_EQ(said("361 1 830 0").size(), 1u);
    EXPECT_EQ(said("550 1").size(), 1u);
}

TEST_F(ParamSpectrumFile, NeitherNameNorFile) {
    const Read none = ReadSpectrum("\"spectrum s\" \"metal-Cu-q\"");
    EXPECT_FALSE(none.spectrum);
    ASSERT_EQ(none.messages.size(), 1u);
    EXPECT_TRUE(none.messages[0].starts_with(
        R"(test.pbrt:2:30: "spectrum s": "metal-Cu-q" is no built-in spectrum, and as a file: )"))
        << none.messages[0];
    EXPECT_TRUE(none.messages[0].ends_with(R"(; did you mean "metal-Cu-k"?)")) << none.messages[0];
    EXPECT_EQ(ReadSpectrum("\"spectrum s\" [ \"a\" \"b\" ]").messages,
              Texts{R"(test.pbrt:2:32: "spectrum s": expected 1 value, found 2)"});
}

TEST(ParamSpectrum, OfSeveralTypesTheLastCounts) {
    const Read last = ReadSpectrum("\"blackbody s\" 3000 \"rgb s\" [ 1 1 1 ]");
    ExpectSame(*last.spectrum, RGBColorSpace::sRGB().UnboundedSpectrum({1, 1, 1}));
}

}  // namespace
}  // namespace pbrt
