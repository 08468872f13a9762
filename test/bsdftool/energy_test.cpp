#include "pbrt/bsdftool/energy.h"
#include "bsdftool/tool_test.h"

namespace pbrt::bsdftool {
namespace {

class Energies : public BsdfTool {
  protected:
    static Albedo From(const std::string &material, double theta, double phi, int samples = 4096) {
        return AlbedoFrom(Read(material), Spherical(theta, phi), MiddleWavelengths(8), samples);
    }
};

TEST_F(Energies, NothingIsLostWhereNothingIsAbsorbed) {
    for (const double theta : {0.0, 50.0, 120.0}) {
        const Albedo white = From("Material \"diffuse\" \"rgb reflectance\" [1 1 1]", theta, 0);
        EXPECT_NEAR(white.Absorbed(), 0, 1e-5);
        EXPECT_EQ(Albedo::Mean(white.transmitted), 0);
        for (const char *glass : {"Material \"dielectric\"",
                                  "Material \"dielectric\" \"spectrum eta\" \"glass-BK7\""}) {
            const Albedo e = From(glass, theta, 0);
            EXPECT_NEAR(Albedo::Mean(e.reflected) + Albedo::Mean(e.transmitted), 1, 1e-4) << glass;
            EXPECT_GT(Albedo::Mean(e.reflected), 0.03);
        }
    }
}

TEST_F(Energies, PartsOfAFeatherSumToTheWhole) {
    for (const double theta : {10.0, 60.0, 115.0}) {
        const double phi = theta < 90 ? 20 : 200;
        const Albedo e = From(kFeather + " \"float spacing\" 2.5", theta, phi);
        EXPECT_NEAR(Albedo::Mean(e.R) + Albedo::Mean(e.TRT),
                    Albedo::Mean(e.reflected) + Albedo::Mean(e.transmitted), 1e-6);
        EXPECT_GT(e.gap, 0.1);
        EXPECT_GT(e.Absorbed(), 0);
        EXPECT_LT(e.error, 0.003);
    }
}

// MODEL section 8: one bounce off a film that reflects everything (a straight row), and the gaps.
TEST_F(Energies, MirrorFilmReturnsWhatTracingReturns) {
    const std::string mirror =
        kFeather +
        " \"float thickness\" 0.1 \"spectrum eta\" [ 300 999 900 999 ] \"rgb melanin\" [ 0 0 0 ]"
        " \"float opening\" 0";
    struct Row {
        std::string more;
        double theta, phi, gap, reflected;
    };
    const Row table[] = {{"", 0, 0, 0, .8760},
                         {"", 60, 0, .0375, .5257},
                         {"", 120, 180, .0375, .5257},  // the same from below
                         {"", 75, 180, 0, .9893},
                         {" \"float tilt\" -0.8", 50, 0, .3312, .3974},
                         {" \"float spacing\" 2.5", 0, 0, .2454, .6671},
                         {" \"float aspect\" 1", 50, 0, 0, .9128}};
    for (const Row &row : table) {
        const Albedo e = From(mirror + row.more, row.theta, row.phi, 1 << 14);
        // The film reflects all but 1e-5 (it is a third of a turn thick); sampling errs by 0.1 %.
        EXPECT_NEAR(Albedo::Mean(e.R), row.reflected, 0.003) << row.more << row.theta;
        EXPECT_NEAR(e.gap, row.gap, 0.002) << row.more << row.theta;
        EXPECT_EQ(Albedo::Mean(e.TRT), 0);
    }
}

TEST_F(Energies, ErrorIsHonest) {
    const Albedo few = From(kFeather, 30, 0, 64), many = From(kFeather, 30, 0, 1 << 14);
    EXPECT_LT(many.error, few.error / 4);
    // Eight shifts make Student's t with 7 degrees of freedom: 5.4 is passed once in 1000.
    EXPECT_LT(std::abs(Albedo::Mean(few.reflected) - Albedo::Mean(many.reflected)),
              5.4 * few.error);
}

TEST_F(Energies, FurnaceIsATable) {
    const std::string text = Succeed({"furnace", kFeather, "--thetas", "0,60", "--phis", "0,90",
                                      "--samples", "256", "--csv", Path("t.csv")});
    const std::vector<std::string> lines = Lines(text);
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_EQ(lines[0],
              " theta    phi   reflected transmitted           R         TRT           T    "
              "absorbed          +-");
    std::ifstream csv(Path("t.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "theta,phi,reflected,transmitted,R,TRT,T,absorbed,error");
    int rows = 0;
    for (; std::getline(csv, line); ++rows) {
        double v[9];
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", v, v + 1, v + 2,
                              v + 3, v + 4, v + 5, v + 6, v + 7, v + 8),
                  9);
        EXPECT_NEAR(v[4] + v[5] + v[6] + v[7], 1, 1e-6) << line;
        EXPECT_NEAR(v[2] + v[3], v[4] + v[5], 1e-6) << line;
    }
    EXPECT_EQ(rows, 4);
    EXPECT_EQ(
        Lines(Succeed({"furnace", "Material \"diffuse\"", "--thetas", "0", "--phis", "0"}))[0],
        " theta    phi   reflected transmitted    absorbed          +-");
}

}  // namespace
}  // namespace pbrt::bsdftool
