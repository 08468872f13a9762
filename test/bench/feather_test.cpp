#include "bench/feather/cases.h"
#include "bench/feather/command.h"
#include "bsdftool/tool_test.h"

namespace pbrt::bench {
namespace {

class Bench : public bsdftool::BsdfTool {
  protected:
    static std::string Table(const std::vector<std::string> &args) {
        const cli::Outcome outcome = bench::Run(args);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }
};

TEST_F(Bench, TellsTimesAndErrors) {
    const std::string text =
        Table({kFeather, "--rounds", "1", "--pairs", "60", "--csv", Path("b.csv")});
    EXPECT_NE(text.find("times sinf"), std::string::npos) << text;
    std::ifstream csv(Path("b.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line,
              "name,f_ns,pdf_ns,sample_ns,sample_without_f_ns,trt_light_error,trt_f_error,"
              "film_error,R_error,pdf_error,T_error");
    std::vector<std::string> names;
    while (std::getline(csv, line)) {
        names.push_back(line.substr(1, line.find('"', 1) - 1));
        const double f = std::stod(line.substr(line.find("\",") + 2));
        EXPECT_GT(f, 0.1) << line;
        EXPECT_LT(f, 1e7) << line;
    }
    ASSERT_GE(names.size(), 4u);
    EXPECT_EQ(names[0], "featherbarbule");
    EXPECT_EQ(names[1], "sinf");
    for (const char *name : {"hair", "conductor, GGX 0.3", "film, real numbers",
                             "film, complex series", "featherbarbule, by 16", "adaptive"})
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}

TEST_F(Bench, OtherMaterialsHaveTimesOnly) {
    const std::string text = Table({"Material \"diffuse\"", "--rounds", "1"});
    EXPECT_EQ(text.find("Gauss"), std::string::npos);
    EXPECT_EQ(text.find("edges"), std::string::npos);
    EXPECT_NE(text.find("diffuse: f "), std::string::npos);
}

TEST_F(Bench, ErrorsFallWithTheOrder) {
    const Material material = Read(kFeather);
    const auto cases = QuadratureCases(std::get<FeatherBarbuleMaterial>(material), 100);
    const auto error = [&](const std::string &name) {
        for (const Case &c : cases)
            if (c.row.name == name) return *c.row.lightError;
        ADD_FAILURE() << name;
        return 0.0;
    };
    EXPECT_LT(error("8 segments x 16"), error("2 segments x 8") / 5);
    EXPECT_LT(error("Gauss, 16 in e"), error("Gauss, 4 in e") / 5);
    // The target for the default, one by one and as it renders.
    EXPECT_LT(error("adaptive"), 0.005);
    EXPECT_LT(error("featherbarbule, by 16"), 0.005);
}

TEST_F(Bench, RealFilmIsNoWorseThanTheSeries) {
    const auto cases = FilmCases();
    ASSERT_EQ(cases.size(), 3u);
    EXPECT_LT(*cases[0].row.filmError, 1e-6);
    EXPECT_LE(*cases[0].row.filmError, *cases[1].row.filmError);
}

TEST_F(Bench, PartsAreAsExactAsFloat) {
    const Material material = Read(kFeather + " \"float spacing\" 2.5");
    const PartErrors e = MeasureParts(std::get<FeatherBarbuleMaterial>(material), 4000);
    EXPECT_GT(e.lit, 100);
    EXPECT_LT(e.R, 1e-5);
    EXPECT_LT(e.pdf, 1e-4);
    EXPECT_LT(e.gap, 2e-5);
}

}  // namespace
}  // namespace pbrt::bench
