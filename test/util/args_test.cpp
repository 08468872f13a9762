#include "pbrt/util/args.h"

#include <gtest/gtest.h>

namespace pbrt {
namespace {

using Words = std::vector<std::string>;

NormalizedArgs Normalize(const Words &words) {
    static const std::vector<ArgOption> options{{"nthreads", true}, {"cropwindow", true},
                                                {"quiet", false},   {"help", false},
                                                {"spp", true},      {"render-coord-sys", true}};
    return NormalizeArgs(words, options);
}

TEST(Args, EverySpellingOfANameIsOne) {
    for (const std::string spelled :
         {"--nthreads", "-nthreads", "--nThreads", "--n-threads", "--n_threads", "-N-Threads"}) {
        EXPECT_EQ(Normalize({spelled, "4"}).args, Words{"--nthreads=4"}) << spelled;
        EXPECT_EQ(Normalize({spelled + "=4"}).args, Words{"--nthreads=4"}) << spelled;
    }
}

TEST(Args, NamesComeOutAsTheProgramSpellsThem) {
    for (const std::string spelled : {"--rendercoordsys", "-Render_Coord_Sys"})
        EXPECT_EQ(Normalize({spelled, "world"}).args, Words{"--render-coord-sys=world"});
}

TEST(Args, ValuesAreLeftAlone) {
    EXPECT_EQ(Normalize({"--cropwindow", "-1,.5,0,1"}).args, Words{"--cropwindow=-1,.5,0,1"});
    EXPECT_EQ(Normalize({"--cropwindow=A_b-C=d"}).args, Words{"--cropwindow=A_b-C=d"});
    EXPECT_EQ(Normalize({"--spp", "--quiet"}).args, Words{"--spp=--quiet"});
}

TEST(Args, FlagsTakeAValueOnlyAfterTheEqualsSign) {
    EXPECT_EQ(Normalize({"-Quiet", "a.pbrt"}).args, (Words{"--quiet", "a.pbrt"}));
    EXPECT_EQ(Normalize({"--quiet=false"}).args, Words{"--quiet=false"});
}

TEST(Args, FilesNumbersAndEverythingAfterTwoDashesAreNoOptions) {
    const Words words{"my-scene_A.pbrt", "-", "-1", "-.5", "", "--", "-quiet", "--no such"};
    EXPECT_EQ(Normalize(words).args, words);
    EXPECT_EQ(Normalize(words).error, "");
}

TEST(Args, HelpHasAShortForm) {
    for (const std::string spelled : {"-h", "--h", "-help", "--help"})
        EXPECT_EQ(Normalize({spelled}).args, Words{"--help"});
}

TEST(Args, UnknownOptionNamesTheNearest) {
    EXPECT_EQ(Normalize({"--nthread", "4"}).error,
              "unknown option --nthread; did you mean --nthreads?");
    EXPECT_EQ(Normalize({"--zzzzzzzzz"}).error, "unknown option --zzzzzzzzz");
    EXPECT_EQ(Normalize({"--=4"}).error, "unknown option --");
}

TEST(Args, MissingValueIsAnError) {
    const std::string needsValue = "option --spp needs a value";
    EXPECT_EQ(Normalize({"a.pbrt", "--spp"}).error, needsValue);
    EXPECT_EQ(Normalize({"--spp", "", "a.pbrt"}).error, needsValue);
    EXPECT_EQ(Normalize({"--spp=", "a.pbrt"}).error, needsValue);
    EXPECT_EQ(Normalize({"--quiet="}).error, "option --quiet needs a value");
}

}  // namespace
}  // namespace pbrt
