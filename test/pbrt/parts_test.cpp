// Parts of a picture, rendered apart and joined: the bits of the whole, or a refusal.

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/program.h"
#include "pbrt/util/rng.h"

namespace pbrt::test {
namespace {

class Parts : public ProgramFolder {
  protected:
    void PutWhole(const std::string &film = "\"rgb\"") const {
        PutBall(film);
        Succeed("pbrt --quiet ball.pbrt --outfile whole.exr");
    }
    /// Renders a part of "ball.pbrt"; its file's name.
    std::string RenderPart(const std::string &name, const std::string &options) const {
        Succeed(fmt::format("pbrt --quiet ball.pbrt --outfile {} {}", name, options));
        return name;
    }
    /// Merges, and expects the whole.
    void ExpectWhole(const std::string &files) const {
        Succeed("imgtool merge --outfile merged.exr " + files);
        EXPECT_TRUE(Get("merged.exr") == Get("whole.exr")) << files;
    }
};

/// The picture is cut at random into two or more crops, and each, at other places, into ranges.
TEST_F(Parts, AnySplitIsTheWhole) {
    const std::vector<std::string> films{"\"rgb\"", "\"gbuffer\"",
                                         "\"spectral\" \"integer nbuckets\" 9",
                                         "\"rgb\" \"bool savefp16\" false"};
    const std::vector<int> borders{1, 4, 16, 32, 64};
    Rng rng{11};
    const auto below = [&](int n) { return int(rng.Uniform() * float(n)); };
    for (const std::string &film : films) {
        PutWhole(film);
        const int x = 1 + below(38), y = 1 + below(22);
        std::vector<std::string> files;
        for (const std::string &crop :
             {fmt::format("0,{},0,24", x), fmt::format("{},40,0,{}", x, y),
              fmt::format("{},40,{},24", x, y)}) {
            std::vector<int> ends{0, 128};
            for (int i = below(3); i > 0; --i)
                ends.push_back(borders[size_t(below(5))]);
            std::sort(ends.begin(), ends.end());
            ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
            for (size_t i = 1; i < ends.size(); ++i)
                files.push_back(RenderPart(fmt::format("part-{}.exr", files.size()),
                                           fmt::format("--pixelbounds {} --sample-range {}:{}",
                                                       crop, ends[i - 1], ends[i])));
        }
        for (size_t i = files.size(); i > 1; --i)
            std::swap(files[i - 1], files[size_t(below(int(i)))]);
        std::string all;
        for (const std::string &file : files)
            all += " " + file;
        SCOPED_TRACE(film);
        ExpectWhole(all);
    }
}

TEST_F(Parts, OfPartsArePartsAgain) {
    PutWhole();
    const std::string a = RenderPart("a.exr", "--sample-range 0:16"),
                      b = RenderPart("b.exr", "--sample-range 16:32"),
                      c = RenderPart("c.exr", "--sample-range 32:128");
    EXPECT_EQ(Succeed("imgtool merge b.exr a.exr --outfile ab.exr"),
              "2 parts joined: the samples 0:32 of 128\n");
    RenderPart("ab-at-once.exr", "--sample-range 0:32");
    EXPECT_TRUE(Get("ab.exr") == Get("ab-at-once.exr"));
    ExpectWhole("c.exr ab.exr");
    EXPECT_EQ(Load("ab.exr").metadata.samplesPerPixel, 32);
    EXPECT_EQ(Load("ab.exr").metadata.strings.at("sampleRange"), "0:32 of 128");
    Refuses("imgtool merge a.exr b.exr --outfile ab.png", "must be an .exr file");
    Refuses("imgtool merge a.exr c.exr --outfile ac.exr", "no file has the samples 16:32");
}

TEST_F(Parts, CropsNeedNoSums) {
    PutWhole();
    RenderPart("left.exr", "--cropwindow 0,0.3,0,1");
    RenderPart("right.exr", "--cropwindow 0.3,1,0,1");
    ExpectWhole("right.exr left.exr");
    EXPECT_EQ(Succeed("imgtool assemble left.exr right.exr --outfile all.exr"), "2 parts joined\n");
    EXPECT_TRUE(Get("all.exr") == Get("whole.exr"));
}

TEST_F(Parts, WhatIsMissingIsRefusedOrBlack) {
    PutWhole();
    RenderPart("left.exr", "--pixelbounds 0,10,0,24");
    RenderPart("right.exr", "--pixelbounds 12,40,0,24");
    Refuses("imgtool merge left.exr right.exr --outfile m.exr", "no file has the pixel (10, 0)");
    EXPECT_NE(Succeed("imgtool assemble left.exr right.exr --outfile m.exr")
                  .find("48 pixels are in no file and black"),
              std::string::npos);
    const Image all = Load("m.exr"), whole = Load("whole.exr");
    ASSERT_EQ(all.Resolution(), whole.Resolution());
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x)
            EXPECT_EQ(all.Get({x, y}, 1), x >= 10 && x < 12 ? 0 : whole.Get({x, y}, 1));
    RenderPart("early.exr", "--pixelbounds 10,12,0,24 --sample-range 0:64");
    RenderPart("late.exr", "--pixelbounds 10,12,0,24 --sample-range 64:128");
    Refuses("imgtool merge left.exr right.exr early.exr --outfile m.exr",
            "has other samples than others");
    ExpectWhole("early.exr left.exr late.exr right.exr");
}

TEST_F(Parts, WhatDoesNotBelongTogetherIsRefused) {
    PutWhole();
    RenderPart("a.exr", "--sample-range 0:64");
    RenderPart("b.exr", "--sample-range 16:128");
    Refuses("imgtool merge a.exr b.exr --outfile m.exr",
            "a.exr and b.exr overlap: they hold the samples 0:64 of the pixels [0, 40) x [0, 24) "
            "and the samples 16:128 of");
    Refuses("imgtool merge a.exr a.exr --outfile m.exr", "overlap");
    Refuses("imgtool merge whole.exr a.exr --outfile m.exr", "overlap");
    RenderPart("seed.exr", "--sample-range 64:128 --seed 5");
    Refuses("imgtool merge a.exr seed.exr --outfile m.exr",
            "a.exr and seed.exr have the seeds 0 and 5; imgtool average joins such pictures");
    RenderPart("spp.exr", "--sample-range 64:256 --spp 256");
    Refuses("imgtool merge a.exr spp.exr --outfile m.exr",
            "are parts of 128 and of 256 samples per pixel");
    RenderPart("diffuse.exr", "--sample-range 64:128 --force-diffuse");
    Refuses("imgtool merge a.exr diffuse.exr --outfile m.exr", "are of different scenes");
    PutBall("\"rgb\"", "# another text\n");
    RenderPart("scene.exr", "--sample-range 64:128");
    Refuses("imgtool merge a.exr scene.exr --outfile m.exr", "are of different scenes");
    PutBall("\"gbuffer\"");
    RenderPart("film.exr", "--sample-range 64:128");
    Refuses("imgtool merge a.exr film.exr --outfile m.exr", "have other channels");
    Succeed("imgtool convert a.exr --outfile plain.exr --channels R,G,B");
    Refuses("imgtool merge plain.exr b.exr --outfile m.exr", "without their sums");
    Succeed("imgtool convert a.exr --outfile plain.pfm");
    Refuses("imgtool merge plain.pfm b.exr --outfile m.exr", "does not say which samples");
    EXPECT_FALSE(IsThere("m.exr"));
}

TEST_F(Parts, BeginAndEndWithBlocks) {
    PutBall("\"rgb\"");
    Refuses("pbrt ball.pbrt --sample-range 10:20", "Around these: 4:32");
    Refuses("pbrt ball.pbrt --sample-range 0:20", "Around these: 0:32");
    Refuses("pbrt ball.pbrt --sample-range 64:129", "the picture has 128 samples per pixel");
    for (const char *const text : {"5", "3:3", "4:1", "-1:4", "a:b", "0:4:8"})
        Refuses(fmt::format("pbrt ball.pbrt --sample-range '{}'", text),
                "--sample-range: expected whole numbers a:b with 0 <= a < b");
    Refuses("pbrt ball.pbrt --sample-range 0:4 --target-error 0.1", "--target-error gives no");
    Refuses("pbrt ball.pbrt --sample-range 0:4 --outfile a.png", "must be an .exr file");
    Succeed("pbrt ball.pbrt --quiet --spp 100 --sample-range 64:100 --outfile a.exr");
    Succeed("pbrt ball.pbrt --quiet --sample-range 0:1e0 --outfile a.exr");
}

TEST_F(Parts, EqualRendersAreEqualFiles) {
    PutWhole();
    Succeed("pbrt --quiet ball.pbrt --outfile again.exr --nthreads 1");
    EXPECT_TRUE(Get("again.exr") == Get("whole.exr"));
}

TEST_F(Parts, AnAverageWeighsBySamples) {
    PutBall("\"rgb\" \"bool savefp16\" false");
    RenderPart("a.exr", "--spp 16");
    RenderPart("b.exr", "--spp 128 --seed 1");
    Succeed("imgtool average a.exr b.exr --outfile mean.exr");
    const Image a = Load("a.exr"), b = Load("b.exr"), mean = Load("mean.exr");
    EXPECT_EQ(mean.metadata.samplesPerPixel, 144);
    EXPECT_EQ(mean.metadata.strings.at("seed"), "0,1");
    for (size_t i = 0; i < mean.Data().size(); ++i)
        ASSERT_NEAR(mean.Data()[i], (16 * a.Data()[i] + 128 * b.Data()[i]) / 144,
                    1e-6 * (1 + mean.Data()[i]));
}

TEST_F(Parts, AnAverageRefusesTheSamePictureTwice) {
    PutBall("\"rgb\"");
    RenderPart("a.exr", "--spp 16");
    RenderPart("b.exr", "--spp 64");
    RenderPart("c.exr", "--spp 16 --seed 1");
    Refuses("imgtool average a.exr b.exr --outfile m.exr",
            "a.exr and b.exr hold the same samples: their scene and seed are the same");
    Refuses("imgtool average a.exr a.exr --outfile m.exr", "hold the same samples");
    Succeed("imgtool average a.exr c.exr --outfile ac.exr");
    Refuses("imgtool average ac.exr c.exr --outfile m.exr", "hold the same samples");
    Succeed("imgtool convert a.exr --outfile a.pfm");
    Succeed("cp a.pfm b.pfm");
    Refuses("imgtool average a.pfm b.pfm --outfile m.exr", "a.pfm and b.pfm are the same picture");
}

}  // namespace
}  // namespace pbrt::test
