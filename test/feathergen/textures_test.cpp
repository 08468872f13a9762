// The two ways to store what varies over a vane.

#include "grow_test.h"
#include "pbrt/feathergen/vane_grid.h"
#include "pbrt/feathergen/vane_textures.h"
#include "render/render_text.h"

namespace pbrt::feathergen {
namespace {

TEST(VaneTextures, AtlasAndFacesHoldTheSameNumbers) {
    const Feather feather(Parameters(), 1);
    const VaneGrid grid(feather);
    const VaneTextures textures(feather);
    ASSERT_EQ(textures.thickness.size(), size_t(grid.NFaces()));
    const Image atlas = Atlas(feather, textures.thickness);
    const PtexContent faces = Faces(feather, textures.thickness);
    EXPECT_EQ(faces.texels, textures.thickness);
    EXPECT_EQ(atlas.Resolution(), (Point2i{grid.nAlong, grid.AtlasRows()}));
    for (int bank = 0; bank < grid.NBanks(); ++bank)
        for (int j = 0; j < grid.nAcross; ++j)
            for (int i = 0; i < grid.nAlong; ++i)
                ASSERT_EQ(atlas.Get({i, grid.AtlasRows() - 1 - grid.AtlasRow(bank, j)}, 0),
                          textures.thickness[size_t(grid.Face(bank, i, j))]);
}

TEST(VaneTextures, NeighboursKnowEachOther) {
    const Feather feather(Parameters(), 1);
    const VaneTextures textures(feather);
    const PtexContent content = Faces(feather, textures.tilt);
    int edges = 0;
    for (int f = 0; f < int(content.faces.size()); ++f)
        for (int e = 0; e < 4; ++e) {
            const PtexFace &face = content.faces[size_t(f)];
            const int other = face.neighbours[size_t(e)];
            if (other < 0) continue;
            ++edges;
            const int back = face.neighbourEdges[size_t(e)];
            EXPECT_EQ(content.faces[size_t(other)].neighbours[size_t(back)], f);
        }
    EXPECT_GT(edges, 3 * int(content.faces.size()));
}

TEST(VaneTextures, FollowMeanGradientAndRise) {
    Parameters p;
    p.thicknessSpread = p.tiltSpread = p.spacingSpread = 0;
    const Feather feather(p, 1);
    const VaneGrid grid(feather);
    const VaneTextures textures(feather);
    double sum = 0;
    for (const float v : textures.thickness)
        sum += double(v);
    // Barbs stand at places 0.1 / n to 1 - 0.5 / n: the mean place is 0.5 - 0.2 / n.
    EXPECT_NEAR(sum / double(textures.thickness.size()),
                p.thickness - p.thicknessGradient * 0.2 / p.barbCount, 1e-3);
    const auto tilt = [&](int across) {
        return (double(textures.tilt[size_t(grid.Face(0, 5, across))]) - 0.5) * double(Pi);
    };
    EXPECT_NEAR(tilt(grid.nAcross - 1), p.tilt, 1e-4);
    EXPECT_GT(tilt(0), p.tilt + 0.3 * p.tiltRise);
    EXPECT_LE(tilt(0), p.tilt + p.tiltRise);
}

constexpr char kView[] = R"(LookAt -60 16 104  0.4 16 0  0 1 0
Camera "perspective" "float fov" 9
Sampler "zsobol" "integer pixelsamples" 16
Integrator "path" "integer maxdepth" 2
Film "rgb" "integer xresolution" 100 "integer yresolution" 140 "string filename" "a.exr"
WorldBegin
LightSource "infinite" "rgb L" [ .1 .1 .1 ]
LightSource "distant" "rgb L" [ 4 4 4 ] "point3 from" [ 40 40 100 ]
)";

const std::string kUnfiltered = "Option \"disabletexturefiltering\" true\n";

/// Mean of |a - b|, of the mean of a.
double RelativeDifference(const Image &a, const Image &b) {
    double difference = 0, sum = 0;
    for (size_t i = 0; i < a.Data().size(); ++i) {
        difference += std::abs(double(a.Data()[i]) - double(b.Data()[i]));
        sum += double(a.Data()[i]);
    }
    return difference / sum;
}

class Pictures : public Grown {
  protected:
    /// Of a feather grown with an option of a value, seen with a line before the scene.
    Image Seen(const std::string &option, const std::string &value,
               const std::string &before) const {
        Succeed({"--seed", "7", option, value, "--out", Path(value)});
        return test::RenderText(before + kView + "Include \"" + Path(value) + "/feather.pbrt\"\n");
    }
};

TEST_F(Pictures, PtexAndAtlasLookTheSame) {
    // The same samples meet the same places and values. Texture coordinates are rounded otherwise
    // (6e-8, times some 100 from texel to film).
    EXPECT_LT(RelativeDifference(Seen("--textures", "atlas", kUnfiltered),
                                 Seen("--textures", "ptex", kUnfiltered)),
              1e-4);
    EXPECT_GT(RelativeDifference(Seen("--set", "thickness=562", kUnfiltered),
                                 Seen("--set", "thickness=562.1", kUnfiltered)),
              1e-4)
        << "a tenth of a nanometre is more";
}

TEST_F(Pictures, FiltersOfPtexAndAtlasAreAlike) {
    // The atlas's ellipses reach a texel to either side at least, Ptex's boxes only as far as the
    // pixel: what the mean of tilts changes of colors. `bilinear` would change 5 % here.
    const Image atlas = Seen("--textures", "atlas", ""), ptex = Seen("--textures", "ptex", "");
    const auto a = test::Mean(atlas), b = test::Mean(ptex);
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(b[c] / a[c], 1, 0.01);
    EXPECT_LT(RelativeDifference(atlas, ptex), 0.025);
}

}  // namespace
}  // namespace pbrt::feathergen
