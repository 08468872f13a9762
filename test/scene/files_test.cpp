// Include, Import, compressed files and standard input.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <fstream>
#include <random>
#include <thread>

#include "pbrt/scene/scene_file.h"
#include "scene/parse.h"
#include "support/damaged.h"
#include "support/gzipped.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

class SceneFiles : public TempFolder {
  protected:
    std::string Write(const std::string &name, const std::string &contents) {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(Path(name), std::ios::binary) << contents;
        return Path(name);
    }
    std::unique_ptr<Parsed> ParseAll(const std::vector<std::string> &files) {
        auto parsed = std::make_unique<Parsed>();
        ParseFiles(files, parsed->scene, parsed->log);
        return parsed;
    }
    /// Messages with the folder's name taken out.
    Texts Short(const Parsed &parsed) const {
        Texts texts = parsed.Messages();
        const std::string prefix = folder.string() + "/";
        for (std::string &t : texts)
            for (size_t at; (at = t.find(prefix)) != t.npos;)
                t.erase(at, prefix.size());
        return texts;
    }
};

TEST_F(SceneFiles, TopLevelFilesFeedOneScene) {
    const auto parsed = ParseAll({Write("a.pbrt", "Camera \"perspective\" WorldBegin Shape \"a\""),
                                  Write("b.pbrt", "Shape \"b\"")});
    EXPECT_EQ(parsed->Messages(), Texts{});
    ASSERT_EQ(parsed->scene.shapes.size(), 2u);
    EXPECT_EQ(All(parsed->scene.shapes)[1].loc.file, Path("b.pbrt"));
    EXPECT_EQ(parsed->scene.dir, folder.string());
}

TEST_F(SceneFiles, IncludeIsTextual) {
    Write("mat.pbrt", "AttributeBegin Material \"diffuse\" Translate 1 0 0");
    const auto parsed = ParseAll({Write("a.pbrt",
                                        "WorldBegin Include \"mat.pbrt\" Shape \"a\"\n"
                                        "AttributeEnd Shape \"b\"")});
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(All(parsed->scene.shapes).at(0).material, 0);
    EXPECT_EQ(All(parsed->scene.shapes).at(1).material, -1);
    EXPECT_EQ(All(parsed->scene.materials).at(0).loc, (FileLoc{Path("mat.pbrt"), 1, 16}));
}

TEST_F(SceneFiles, NestedIncludesStartFromTheTopLevelFolder) {
    Write("sub/one.pbrt", "Include \"sub/two.pbrt\" Shape \"one\"");
    Write("sub/two.pbrt", "Shape \"two\"");
    const auto parsed = ParseAll({Write("a.pbrt", "WorldBegin Include \"sub/one.pbrt\"")});
    EXPECT_EQ(parsed->Messages(), Texts{});
    ASSERT_EQ(parsed->scene.shapes.size(), 2u);
    EXPECT_EQ(All(parsed->scene.shapes)[0].type, "two");
}

TEST_F(SceneFiles, IncludeFallsBackToTheCurrentFolder) {
    Write("scenes/a.pbrt", "WorldBegin Include \"b.pbrt\"");
    Write("b.pbrt", "Shape \"b\"");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    const auto parsed = ParseAll({"scenes/a.pbrt"});
    std::filesystem::current_path(before);
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(parsed->scene.shapes.size(), 1u);
}

TEST_F(SceneFiles, AFileMayBeIncludedTwiceButNotInItself) {
    Write("leaf.pbrt", "Shape \"leaf\"");
    const auto twice =
        ParseAll({Write("a.pbrt", "WorldBegin Include \"leaf.pbrt\" Include \"leaf.pbrt\"")});
    EXPECT_EQ(twice->Messages(), Texts{});
    EXPECT_EQ(twice->scene.shapes.size(), 2u);

    Write("one.pbrt", "Include \"sub/../two.pbrt\"");
    Write("sub/empty", "");
    Write("two.pbrt", "Shape \"two\"\nInclude \"one.pbrt\" Shape \"after\"");
    const auto cycle = ParseAll({Write("c.pbrt", "WorldBegin Include \"one.pbrt\"")});
    EXPECT_EQ(Short(*cycle), Texts{"sub/../two.pbrt:2:9: the file includes itself: \"one.pbrt\" -> "
                                   "\"sub/../two.pbrt\" -> \"one.pbrt\""});
    EXPECT_EQ(cycle->scene.shapes.size(), 2u);  // reading goes on after the refused Include
}

TEST_F(SceneFiles, MissingFilesAreErrorsWhereTheyAreNamed) {
    const auto included =
        ParseAll({Write("a.pbrt", "WorldBegin\nInclude \"no.pbrt\" Shape \"a\"")});
    EXPECT_EQ(Short(*included), Texts{"a.pbrt:2:9: there is no file \"no.pbrt\""});
    EXPECT_EQ(included->scene.shapes.size(), 1u);
    EXPECT_EQ(included->log.MissingFiles().size(), 1u);
    EXPECT_EQ(Short(*ParseAll({Path("none.pbrt")})).at(0),
              "cannot read \"none.pbrt\": No such file or directory");
    EXPECT_EQ(Short(*ParseAll({folder.string() + "/."})).at(0),
              "cannot read \".\": Is a directory");
}

TEST_F(SceneFiles, ImportKeepsItsStateToItself) {
    Write("part.pbrt", R"(
        Shape "inherits"
        Translate 1 0 0 Material "conductor" ReverseOrientation ColorSpace "rec2020"
        CoordinateSystem "inside" Attribute "shape" "float alpha" 0
        MakeNamedMaterial "gold" "string type" "conductor"
        Texture "t" "float" "constant"
        ObjectBegin "o" Shape "s" ObjectEnd
        Shape "imported")");
    const auto parsed = ParseAll({Write("a.pbrt", R"(WorldBegin
        Scale 2 2 2 Material "diffuse"
        Import "part.pbrt"
        Shape "after" NamedMaterial "gold" Shape "b" ObjectInstance "o")")});
    EXPECT_EQ(parsed->Messages(), Texts{});
    const auto s = All(parsed->scene.shapes);
    ASSERT_EQ(s.size(), 4u);
    EXPECT_EQ(s[0].worldFromObject[0], *Transform::Scale({2, 2, 2}));
    EXPECT_EQ(s[0].material, 0);
    EXPECT_EQ(s[1].type, "imported");
    EXPECT_EQ(s[1].material, 1);
    EXPECT_EQ(s[2].type, "after");
    EXPECT_EQ(s[2].material, 0);
    EXPECT_FALSE(s[2].reverseOrientation);
    EXPECT_EQ(s[2].worldFromObject[0], *Transform::Scale({2, 2, 2}));
    EXPECT_TRUE(s[2].params.empty());
    EXPECT_EQ(s[2].colorSpace, &RGBColorSpace::sRGB());
    EXPECT_EQ(parsed->scene.textures.size(), 1u);
}

TEST_F(SceneFiles, ImportSeesNoCoordinateSystemsAndLeaksNone) {
    Write("part.pbrt", "CoordSysTransform \"outside\" CoordinateSystem \"inside\"");
    const auto parsed =
        ParseAll({Write("a.pbrt",
                        "WorldBegin CoordinateSystem \"outside\"\nImport \"part.pbrt\"\n"
                        "CoordSysTransform \"outside\" CoordSysTransform \"inside\"")});
    ASSERT_EQ(parsed->Messages().size(), 2u);
    EXPECT_EQ(Short(*parsed)[0].substr(0, 14), "part.pbrt:1:19");
    EXPECT_EQ(Short(*parsed)[1].substr(0, 11), "a.pbrt:3:47");
}

TEST_F(SceneFiles, ScopesOpenedByAnImportEndInIt) {
    Write("part.pbrt", "AttributeBegin Shape \"a\"");
    Write("close.pbrt", "AttributeEnd");
    const auto parsed = ParseAll({Write("a.pbrt",
                                        "WorldBegin AttributeBegin\nImport \"part.pbrt\"\n"
                                        "Import \"close.pbrt\"\nAttributeEnd")});
    EXPECT_EQ(Short(*parsed), (Texts{"part.pbrt:1:1: AttributeBegin without AttributeEnd",
                                     "close.pbrt:1:1: AttributeEnd without AttributeBegin"}));
}

TEST_F(SceneFiles, ImportIntoAnObjectFillsIt) {
    Write("part.pbrt", "Shape \"a\"");
    const auto parsed = ParseAll({Write(
        "a.pbrt", "WorldBegin ObjectBegin \"o\" Import \"part.pbrt\" ObjectEnd Shape \"b\"")});
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(parsed->scene.objects.at("o").shapes.size(), 1u);
    EXPECT_EQ(parsed->scene.shapes.size(), 1u);
}

TEST_F(SceneFiles, CompressedFilesAreRead) {
    Write("part.pbrt.GZ", Gzipped("Shape \"part\""));
    const auto parsed =
        ParseAll({Write("a.pbrt.gz", Gzipped("WorldBegin Include \"part.pbrt.GZ\" Shape \"a\""))});
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(parsed->scene.shapes.size(), 2u);
}

TEST_F(SceneFiles, UncompressedContentsInGzAreAnErrorAndTheReverse) {
    EXPECT_EQ(Short(*ParseAll({Write("a.pbrt.gz", "WorldBegin")})).at(0),
              "cannot read \"a.pbrt.gz\": the compressed data is damaged (incorrect header check)");
    EXPECT_EQ(Short(*ParseAll({Write("b.pbrt", Gzipped("WorldBegin"))})).at(0),
              "b.pbrt: the file is compressed; name it .gz");
}

TEST_F(SceneFiles, FilesThatAreNotTextAreOneError) {
    EXPECT_EQ(Short(*ParseAll({Write("a.pbrt", std::string("Shape\0\0", 7))})).at(0),
              "a.pbrt: the file is not text");
    EXPECT_EQ(Short(*ParseAll({Write("b.pbrt", std::string("\xFF\xFEW\0", 4))})).at(0),
              "b.pbrt: the file is in UTF-16; scene files are UTF-8");
}

TEST_F(SceneFiles, StandardInputIsRead) {
    for (const std::vector<std::string> &files : {std::vector<std::string>{}, {"-"}}) {
        Write("in.pbrt", "WorldBegin\nShape \"a\" Shpe");
        ASSERT_TRUE(std::freopen(Path("in.pbrt").c_str(), "rb", stdin));
        const auto parsed = ParseAll(files);
        EXPECT_EQ(parsed->Messages(),
                  Texts{"<stdin>:2:11: unknown directive \"Shpe\"; did you mean \"Shape\"?"});
        EXPECT_EQ(parsed->scene.shapes.size(), 1u);
    }
}

TEST(Gunzip, ReadsEveryMember) {
    std::string why;
    EXPECT_EQ(Gunzip(Gzipped("one ") + Gzipped("") + Gzipped("two"), why), "one two");
    EXPECT_EQ(Gunzip(Gzipped("padded") + std::string(512, '\0'), why), "padded");
    std::string large;
    for (int i = 0; large.size() < 5'000'000; ++i)
        large += std::to_string(i % 1009 * 7919) + ' ';
    EXPECT_EQ(Gunzip(Gzipped(large), why), large);
}

TEST(Gunzip, RefusesDamagedData) {
    const std::string whole = Gzipped("Some text that is worth compressing, some text, some text");
    std::string why;
    for (size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(Gunzip(whole.substr(0, size), why)) << size;
    EXPECT_EQ(why, "the compressed data is cut short");
    for (size_t i = whole.size() - 8; i < whole.size(); ++i) {  // checksum and length
        std::string damaged = whole;
        damaged[i] = char(damaged[i] ^ 1);
        EXPECT_FALSE(Gunzip(damaged, why)) << i;
    }
    EXPECT_EQ(why, "the compressed data is damaged (incorrect length check)");
    EXPECT_FALSE(Gunzip(whole + "more", why));
}

TEST(Gunzip, FlippedBytesAreReadOrRefused) {
    std::string text;
    for (int i = 0; i < 300; ++i)
        text += std::to_string(i * 7919 % 1009) + ' ';
    const std::string whole = Gzipped(text);
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
        std::string why;
        const auto read = Gunzip(Damaged(whole, random), why);
        EXPECT_NE(read.has_value(), !why.empty());
        // What passes unseen is in the header: a name, a time.
        EXPECT_EQ(read.value_or(text), text);
    }
}

TEST_F(SceneFiles, PipesOfTheCommandLineAreRead) {
    ASSERT_EQ(mkfifo(Path("pipe").c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(Path("pipe")) << "WorldBegin Shape \"a\""; });
    const auto parsed = ParseAll({Path("pipe")});
    writer.join();
    EXPECT_EQ(parsed->Messages(), Texts{});
    EXPECT_EQ(parsed->scene.shapes.size(), 1u);
}

TEST(Paths, FolderOfIsWhatPrecedesTheLastSlash) {
    EXPECT_EQ(FolderOf("a.pbrt"), "");
    EXPECT_EQ(FolderOf("x/y/a.pbrt"), "x/y");
    EXPECT_EQ(FolderOf("/a.pbrt"), "/");
}

}  // namespace
}  // namespace pbrt
