#include <cmath>
#include <random>
#include <regex>
#include <sstream>

#include "bsdftool/tool_test.h"
#include "feather/model.h"
#include "pbrt/bsdftool/directions.h"
#include "pbrt/bsdftool/evaluation.h"
#include "support/damaged.h"

namespace pbrt::bsdftool {
namespace {

constexpr std::string_view kHeader = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n";

/// The numbers of `"key":value` or `"key":[values]` in a line of JSON.
std::vector<double> Numbers(const std::string &line, const std::string &key) {
    std::smatch match;
    if (!std::regex_search(line, match, std::regex("\"" + key + "\":\\[?([^\\]\"}]*)"))) return {};
    std::vector<double> numbers;
    std::istringstream in(match[1].str());
    for (std::string cell; std::getline(in, cell, ',') && !cell.empty();)
        numbers.push_back(std::stod(cell));
    return numbers;
}

class Eval : public BsdfTool {
  protected:
    std::string Pairs(const std::string &lines) const {
        Put("pairs.csv", std::string(kHeader) + lines);
        return Path("pairs.csv");
    }
    /// The last lines are not unit, one has blanks and a sign, and there is an empty one.
    std::string SomePairs() const {
        return Pairs(
            "0,0,1,0.6,0,0.8\n0.36,0.48,0.8,0,0,1\n0.6,0,0.8,-0.6,0,-0.8\n"
            "3, 4,+12 ,-1e-3,0,2e-3\r\n\n-1,0.1,1,-0.1,0,1\n");
    }
};

TEST_F(Eval, WritesOneObjectALine) {
    const std::string number = "-?[0-9.]+(e[+-][0-9]+)?";
    const std::string three = "\\[" + number + "," + number + "," + number + "\\]";
    const std::regex plain("\\{\"wo\":" + three + ",\"wi\":" + three +
                           ",\"lambda\":\\[450,550,650\\],\"f\":" + three + ",\"pdf\":" + number +
                           "\\}");
    const std::regex feather("\\{\"wo\":" + three + ",\"wi\":" + three +
                             ",\"lambda\":\\[450,550,650\\],\"f\":" + three + ",\"pdf\":" + number +
                             ",\"gap\":" + number + ",\"R\":" + three + ",\"TRT\":" + three +
                             "\\}");
    const std::vector<std::string> args{"--directions", SomePairs(), "--wavelengths",
                                        "450,550,650"};
    const auto run = [&](std::vector<std::string> all) {
        all.insert(all.end(), args.begin(), args.end());
        const std::vector<std::string> lines = Lines(Succeed(all));
        EXPECT_EQ(lines.size(), 5u);
        return lines;
    };
    for (const std::string &line : run({"eval", kFeather}))
        EXPECT_TRUE(std::regex_match(line, feather)) << line;
    for (const std::string &line : run({"eval", kFeather, "--double"}))
        EXPECT_TRUE(std::regex_match(line, feather)) << line;
    for (const std::string &line : run({"eval", "Material \"diffuse\""}))
        EXPECT_TRUE(std::regex_match(line, plain)) << line;
}

TEST_F(Eval, NumbersHaveNineDigits) {
    Evaluation e;
    e.f = {1.0 / 3, 2e-12 / 3};
    e.pdf = 1e9 / 7;
    EXPECT_EQ(JsonLine({{0, 0, 1}, {0.6, 0, -0.8}}, {450, 550.25f}, e),
              "{\"wo\":[0,0,1],\"wi\":[0.6,0,-0.8],\"lambda\":[450,550.25],"
              "\"f\":[0.333333333,6.66666667e-13],\"pdf\":142857143}");
    e.hasParts = true;
    e.gap = 0.25;
    e.R = {1.0 / 7};
    e.TRT = {0};
    EXPECT_EQ(JsonLine({{0, 0, 1}, {0, 1, 0}}, {450}, e),
              "{\"wo\":[0,0,1],\"wi\":[0,1,0],\"lambda\":[450],"
              "\"f\":[0.333333333,6.66666667e-13],\"pdf\":142857143,"
              "\"gap\":0.25,\"R\":[0.142857143],\"TRT\":[0]}");
}

// The model itself, in double and for exactly these three wavelengths. The material holds its
// parameters in float and the index of keratin in a table of floats: 1e-6 relative.
TEST_F(Eval, AgreesWithTheModelInDouble) {
    using Exact = feather::Barbule<double, 3, feather::Converged<16, 8>>;
    const feather::Shape shape{.thickness = 595, .spacing = 2.5, .tilt = double(-0.35f)};
    feather::Optics<double, 3> optics;
    optics.lambda = {450, 550, 650};
    for (int i = 0; i < 3; ++i) {
        optics.eta[i] = feather::KeratinIndex(feather::Nm<double>{optics.lambda[i]});
        optics.melanin[i] = feather::MelaninReflectance(feather::Nm<double>{optics.lambda[i]});
    }
    auto params = feather::ParamsOf<double>(shape);
    params.opening = {double(0.0785f)};
    const Exact exact(params, optics);

    const std::string material = kFeather + " \"float thickness\" 595 \"float spacing\" 2.5";
    const std::string pairs = SomePairs();
    int lit = 0;
    for (const bool inDouble : {true, false}) {
        std::vector<std::string> args{"eval", material,        "--directions",
                                      pairs,  "--wavelengths", "450,550,650"};
        if (inDouble) args.push_back("--double");
        for (const std::string &line : Lines(Succeed(args))) {
            const std::vector<double> o = Numbers(line, "wo"), i = Numbers(line, "wi");
            const feather::Direction<double> wo{o[0], o[1], o[2]}, wi{i[0], i[1], i[2]};
            EXPECT_NEAR(Dot(wo, wo), 1, 1e-8);
            const auto view = exact.SeenFrom(wo);
            const double near = inDouble ? 3e-6 : 1e-4, ofTRT = inDouble ? 3e-6 : 5e-3;
            const auto R = exact.R(view, wi), TRT = exact.TRT(view, wi);
            EXPECT_NEAR(Numbers(line, "pdf")[0], exact.PDF(view, wi), near) << line;
            EXPECT_NEAR(Numbers(line, "gap")[0], exact.GapFraction(wo), 1e-5) << line;
            for (size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(Numbers(line, "R")[k], R[k], near * R[k]) << line;
                EXPECT_NEAR(Numbers(line, "TRT")[k], TRT[k], ofTRT * TRT[k]) << line;
                EXPECT_NEAR(Numbers(line, "f")[k], R[k] + TRT[k], near * R[k] + ofTRT * TRT[k]);
                lit += R[k] > 0;
            }
        }
    }
    EXPECT_GE(lit, 12);
}

TEST_F(Eval, AnyNumberOfWavelengths) {
    const Material material = Read(kFeather);
    const DirectionPair pair{Spherical(20, 180), Spherical(25, 170)};
    const std::vector<float> lambda{400, 450, 500, 550, 600, 650, 700};
    for (size_t n = 1; n <= lambda.size(); ++n) {
        const Evaluation some =
            EvaluateOracle(material, pair, {lambda.begin(), lambda.begin() + n});
        ASSERT_EQ(some.f.size(), n);
        const Evaluation last = EvaluateOracle(material, pair, {lambda[n - 1]});
        EXPECT_GT(some.R.back(), 0);
        EXPECT_NEAR(some.f.back(), last.f[0], 1e-12);
        EXPECT_NEAR(some.TRT.back(), last.TRT[0], 1e-12);
    }
}

// Dispersion ends the secondary wavelengths of a path; here each has its own index.
TEST_F(Eval, DispersionIsSeen) {
    const Material glass =
        Read("Material \"dielectric\" \"spectrum eta\" \"glass-F11\" \"float roughness\" 0.3");
    const DirectionPair through{Spherical(40, 0), Spherical(155, 180)};
    const std::vector<double> f = Evaluate(glass, through, {420, 500, 600, 700}).f;
    EXPECT_EQ(f[1], Evaluate(glass, through, {500}).f[0]);
    EXPECT_GT(std::abs(f[0] - f[1]), 1e-3 * f[0]);
    EXPECT_GT(std::abs(f[2] - f[3]), 1e-4 * f[2]);
}

TEST_F(Eval, OnlyTheFeatherHasADoubleOracle) {
    EXPECT_EQ(Fail({"eval", "Material \"diffuse\"", "--double", "--directions", SomePairs()}),
              "Error: --double: material \"diffuse\" is written in float only; there is a double "
              "oracle of \"featherbarbule\" alone\n");
}

TEST_F(Eval, EveryBadLineIsNamed) {
    const std::string file = Pairs(
        "0,0,1,0,0,1\n0,0,0,0,0,1\n0,0,1,nan,0,1\n0,0,1,0,0\n0,0,1,0,inf,1\n1,2,3,4,5,six\n"
        "0,0,1,0,0,-0\n");
    EXPECT_EQ(Fail({"eval", kFeather, "--directions", file}),
              "Error: " + file +
                  ":3:1: wo = (0, 0, 0) is no direction: it must be finite and not "
                  "0\nError: " +
                  file +
                  ":4:1: wi = (nan, 0, 1) is no direction: it must be finite and "
                  "not 0\nError: " +
                  file + ":5:1: expected six numbers, found \"0,0,1,0,0\"\nError: " + file +
                  ":6:1: wi = (0, inf, 1) is no direction: it must be finite and not 0\n"
                  "Error: " +
                  file + ":7:1: expected six numbers, found \"1,2,3,4,5,six\"\nError: " + file +
                  ":8:1: wi = (0, 0, -0) is no direction: it must be finite and not 0\n");
    Put("bad.csv", "x,y\n");
    EXPECT_EQ(Fail({"eval", kFeather, "--directions", Path("bad.csv")}),
              "Error: " + Path("bad.csv") +
                  ":1:1: expected the header \"wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\"\n");
    EXPECT_EQ(Fail({"eval", kFeather, "--directions", Path("none.csv")}),
              "Error: " + Path("none.csv") + ": cannot be opened: No such file or directory\n");
    EXPECT_EQ(Fail({"eval", kFeather, "--directions", SomePairs(), "--wavelengths", "450,300"}),
              "Error: --wavelengths: 300 is outside [360, 830]\n");
}

TEST_F(Eval, DamagedFilesAreReadOrRefused) {
    const std::string good =
        "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,3e200,4e200,3e-200,0,4e-200\n"
        "0.1,-0.2,1,0,+0.5,1\n\n-1,2,3,4,5,6\n";
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        Put("bad.csv", Damaged(good, random));
        Diagnostics log;
        for (const DirectionPair &pair : ReadDirections(Path("bad.csv"), log))
            for (const LocalDirection &w : {pair.wo, pair.wi})
                // Three roundings of components, three of the length.
                EXPECT_NEAR(std::hypot(w.x, w.y, w.z), 1, 6e-16);
    }
}

TEST_F(Eval, MessagesShowNoLongLines) {
    const std::string file = Pairs(std::string(1 << 20, '1') + "\n");
    EXPECT_LT(Fail({"eval", kFeather, "--directions", file}).size(), file.size() + 150);
}

TEST_F(Eval, HugeAndTinyVectorsAreDirections) {
    const std::string file = Pairs("0,3e200,4e200,3e-200,0,4e-200\n1e308,1e308,1e308,0,0,5e-324\n");
    const std::vector<std::string> lines = Lines(Succeed({"eval", kFeather, "--directions", file}));
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(Numbers(lines[0], "wo"), (std::vector<double>{0, 0.6, 0.8}));
    EXPECT_EQ(Numbers(lines[0], "wi"), (std::vector<double>{0.6, 0, 0.8}));
    EXPECT_EQ(Numbers(lines[1], "wo")[0], 0.577350269);
    EXPECT_EQ(Numbers(lines[1], "wi")[2], 1);
}

TEST_F(Eval, WritesAFileInstead) {
    const std::vector<std::string> args{"eval", kFeather, "--directions", SomePairs()};
    std::vector<std::string> toFile = args;
    toFile.insert(toFile.end(), {"--outfile", Path("out.jsonl")});
    const std::string text = Succeed(args);
    EXPECT_EQ(Succeed(toFile), "");
    std::ifstream in(Path("out.jsonl"));
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text);
}

}  // namespace
}  // namespace pbrt::bsdftool
