// No threads to be had, or far too many asked for.

#include "faults/faults.h"

namespace pbrt::test {
namespace {

class FaultsOfThreads : public Faults {};

TEST_F(FaultsOfThreads, NoneToBeHad) {
    if (!CanLimitThreads()) GTEST_SKIP() << "threads cannot be limited here";
    PutScene("Shape \"sphere\"");
    ASSERT_EQ(Render().exitCode, 0);
    const std::string right = Get("out.pfm");
    for (int threads : {1, 2, 3, 5}) {
        for (const char *wanted : {"1", "4"}) {
            EXPECT_TRUE(Ended(Render({.threads = threads}, {"--nthreads", wanted})))
                << threads << " threads, " << wanted << " wanted";
            EXPECT_TRUE(Get("out.pfm") == right);
        }
    }
    EXPECT_EQ(Files(), (std::vector<std::string>{"out.pfm", "scene.pbrt"}));
}

TEST_F(FaultsOfThreads, NoneToBeHadByATool) {
    if (!CanLimitThreads()) GTEST_SKIP() << "threads cannot be limited here";
    const std::vector<std::string> args{"plot", "Material \"diffuse\"", "--png", "s.png"};
    const Outcome outcome = Run("bsdftool", args, {.threads = 1});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.said;
}

TEST_F(FaultsOfThreads, FarTooManyAskedFor) {
    PutScene("Shape \"sphere\"");
    ASSERT_EQ(Render().exitCode, 0);
    const std::string right = Get("out.pfm");
    for (const char *threads : {"100000", "2147483647"}) {
        EXPECT_TRUE(Ended(Render({}, {"--nthreads", threads}))) << threads;
        EXPECT_TRUE(Get("out.pfm") == right);
    }
}

}  // namespace
}  // namespace pbrt::test
