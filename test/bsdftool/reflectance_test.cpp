#include "pbrt/bsdftool/reflectance.h"

#include "bsdftool/tool_test.h"

namespace pbrt::bsdftool {
namespace {

class Reflectance : public BsdfTool {
  protected:
    /// Barbules as flat as they come, side by side and straight, over black: a film of keratin.
    static std::string FlatFilm(float thickness) {
        return kFeather + " \"float thickness\" " + std::to_string(thickness) +
               " \"float aspect\" 0.001 \"float spacing\" 2 \"float tilt\" 0"
               " \"float opening\" 0 \"rgb melanin\" [ 0 0 0 ]";
    }
    static ReflectanceTable Tabulate(const std::string &material, std::vector<float> thetas,
                                     float step = 1, const Spectrum &light = Spectrum(1)) {
        return TabulateReflectance(
            Read(material), {.thetas = std::move(thetas), .step = step, .samples = 256}, light);
    }
    static std::vector<float> Peaks(const ReflectanceTable &table, size_t angle) {
        const std::vector<double> &R = table.angles[angle].energy.R;
        std::vector<float> peaks;
        for (size_t i = 1; i + 1 < R.size(); ++i)
            if (R[i] > R[i - 1] && R[i] >= R[i + 1]) peaks.push_back(table.lambda[i]);
        return peaks;
    }
};

// PHYSICS: peaks of the free film; the lists end near 375 nm, where one more may follow.
TEST_F(Reflectance, PeaksOfAFlatFilm) {
    struct Row {
        float thickness;
        std::vector<std::vector<float>> peaks;
    };
    const Row table[] = {
        {530, {{371, 472, 655}, {448, 621}, {423, 584}, {396, 546}, {376, 516}}},
        {595, {{414, 528, 734}, {394, 501, 695}, {372, 472, 654}, {442, 611}, {419, 577}}},
        {650, {{372, 451, 576, 801}, {428, 546, 759}, {404, 514, 713}, {481, 665}, {455, 629}}}};
    for (const Row &row : table) {
        const ReflectanceTable t = Tabulate(FlatFilm(row.thickness), {0, 30, 45, 60, 75});
        for (size_t a = 0; a < row.peaks.size(); ++a) {
            const std::vector<float> peaks = Peaks(t, a);
            for (const float expected : row.peaks[a]) {
                float nearest = 1e9f;
                for (const float p : peaks)
                    nearest = std::min(nearest, std::abs(p - expected));
                EXPECT_LE(nearest, 1) << row.thickness << " " << a << " " << expected;
            }
            EXPECT_LE(peaks.size(), row.peaks[a].size() + 1);
        }
    }
}

TEST_F(Reflectance, ValuesOfAFlatFilm) {
    const ReflectanceTable t = Tabulate(FlatFilm(595), {0, 60}, 10);
    const double at[2][7] = {{.139658, .031520, .118876, .142920, .009843, .049629, .146410},
                             {.061252, .271881, .031305, .159913, .270924, .241245, .120059}};
    for (size_t a = 0; a < 2; ++a)
        for (size_t i = 0; i < 7; ++i) {
            EXPECT_EQ(t.lambda[4 + 5 * i], 400 + 50 * i);
            EXPECT_NEAR(t.angles[a].energy.R[4 + 5 * i], at[a][i], 0.002);
        }
}

// Yin et al. 2006: from normal to oblique, green turns purple and purple turns green.
TEST_F(Reflectance, GreenAndPurpleChangePlaces) {
    const ReflectanceTable green = Tabulate(FlatFilm(595), {0, 45}, 2),
                           purple = Tabulate(FlatFilm(530), {0, 60}, 2);
    const auto expect = [](const XYZ &c, float x, float y) {
        EXPECT_NEAR(c.X / (c.X + c.Y + c.Z), x, 0.002f);
        EXPECT_NEAR(c.Y / (c.X + c.Y + c.Z), y, 0.002f);
    };
    expect(green.angles[0].color, 0.247f, 0.443f);
    expect(green.angles[1].color, 0.346f, 0.236f);
    expect(purple.angles[0].color, 0.343f, 0.229f);
    expect(purple.angles[1].color, 0.356f, 0.461f);
}

TEST_F(Reflectance, GrayHasTheColorOfTheLight) {
    const std::string gray = "Material \"diffuse\" \"rgb reflectance\" [ .4 .4 .4 ]";
    const XYZ c = Tabulate(gray, {-30}, 5, *GetNamedSpectrum("stdillum-D65")).angles[0].color;
    EXPECT_NEAR(c.Y, 0.4f, 1e-3);
    EXPECT_NEAR(c.X / (c.X + c.Y + c.Z), 0.3127f, 1e-3);
    EXPECT_NEAR(c.Y / (c.X + c.Y + c.Z), 0.3290f, 1e-3);
}

TEST_F(Reflectance, WritesTableAndPlot) {
    const std::string text =
        Succeed({"spectrum", FlatFilm(595), "--thetas", "0,45", "--step", "5", "--samples", "64",
                 "--csv", Path("s.csv"), "--png", Path("s.png")});
    EXPECT_EQ(Lines(text).size(), 3u);
    std::ifstream csv(Path("s.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "theta,phi,lambda,reflectance,R,TRT");
    int rows = 0;
    while (std::getline(csv, line))
        ++rows;
    EXPECT_EQ(rows, 2 * 95);

    const Image png = Load(Path("s.png"));
    const auto [width, height] = png.Resolution();
    EXPECT_EQ(width, 900);
    size_t drawn = 0;
    for (float v : png.Data())
        drawn += v < 0.9f;
    EXPECT_GT(drawn, png.Data().size() / 50);
    // The strip: green to the left, purple to the right.
    const float *left = png.Pixel({200, 550}), *right = png.Pixel({700, 550});
    EXPECT_GT(left[1], 1.5f * std::max(left[0], left[2]));
    EXPECT_GT(std::min(right[0], right[2]), 1.5f * right[1]);
}

}  // namespace
}  // namespace pbrt::bsdftool
