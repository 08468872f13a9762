// render.sh, in a repository that has nothing to install and nothing to build.

#include "faults/faults.h"
#include "support/folders.h"

namespace pbrt::test {
namespace {

namespace fs = std::filesystem;

class RenderSh : public Faults {
  protected:
    void SetUp() override {
        Faults::SetUp();
        for (const char *made :
             {"repository/scripts", "repository/build", "repository/scenes/own", "a stranger's"})
            fs::create_directories(Path(made));
        fs::copy_file(SourceDir() + "/render.sh", Path("repository/render.sh"));
        fs::create_directory_symlink(ProgramDir(), Path("repository/build/bin"));
        Put("repository/scripts/setup.sh",
            "say() { printf '%s\\n' \"$*\" >&2; }\ninstall_packages() { :; }\n"
            "configure_and_build() { :; }\n");
        for (const char *of : {"repository/scenes/own/", "a stranger's/"}) {
            PutScene("Include \"made.pbrt\"");
            fs::rename(Path("scene.pbrt"), Path(of + std::string("scene.pbrt")));
            const std::string script = Path(of + std::string("generate.sh"));
            Put(of + std::string("generate.sh"),
                "#!/bin/sh\ncd \"$(dirname \"$0\")\" && echo 'Shape \"sphere\"' >made.pbrt\n");
            fs::permissions(script, fs::perms::owner_all);
        }
    }
    /// In the folder `in`.
    Outcome Do(const std::string &in, const std::vector<std::string> &args) const {
        return Process(Path("repository/render.sh"), args, Path(in)).Wait();
    }
};

TEST_F(RenderSh, RunsNoScriptOfAStrangerUnasked) {
    const Outcome unasked = Do("a stranger's", {"scene.pbrt"});
    EXPECT_EQ(unasked.exitCode, 1);
    for (const char *words : {"./generate.sh is not run", "./render.sh --generate scene.pbrt",
                              "generate.sh may make it"})
        EXPECT_NE(unasked.said.find(words), std::string::npos) << unasked.said;
    EXPECT_FALSE(fs::exists(Path("a stranger's/made.pbrt")));
    const Outcome asked = Do(".", {"a stranger's/scene.pbrt", "--spp", "1", "--generate"});
    EXPECT_EQ(asked.exitCode, 0) << asked.said;
    EXPECT_TRUE(fs::exists(Path("scene.png")));
}

TEST_F(RenderSh, RunsThoseOfTheRepository) {
    const Outcome outcome = Do(".", {"repository/scenes/own/scene.pbrt"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.said;
    EXPECT_TRUE(fs::exists(Path("scene.exr")));
    EXPECT_TRUE(fs::exists(Path("scene.png")));
}

/// A link in a stranger's folder to a scene of ours.
TEST_F(RenderSh, TheFolderCountsNotTheScene) {
    fs::remove(Path("a stranger's/scene.pbrt"));
    fs::create_symlink(Path("repository/scenes/own/scene.pbrt"), Path("a stranger's/scene.pbrt"));
    EXPECT_EQ(Do("a stranger's", {"scene.pbrt"}).exitCode, 1);
    EXPECT_FALSE(fs::exists(Path("a stranger's/made.pbrt")));
}

TEST_F(RenderSh, NamesThatLookLikeOptions) {
    PutScene("Shape \"sphere\"");
    fs::rename(Path("scene.pbrt"), Path("-x.pbrt"));
    EXPECT_EQ(Do(".", {"-x.pbrt"}).exitCode, 0);
    EXPECT_TRUE(fs::exists(Path("-x.exr")));
    EXPECT_TRUE(fs::exists(Path("-x.png")));
    EXPECT_EQ(Do(".", {"./-x.pbrt", "--outfile", "-y.pfm"}).exitCode, 0);
    EXPECT_TRUE(fs::exists(Path("-y.png")));
    EXPECT_EQ(Do(".", {"./-x.pbrt", "--outfile=-z.exr"}).exitCode, 0);
    EXPECT_TRUE(fs::exists(Path("-z.png")));
}

}  // namespace
}  // namespace pbrt::test
