// `pbrt --format`: the same tokens, the same comments, the same picture.

#include <filesystem>

#include "pbrt/scene/lexer.h"
#include "pbrt/util/read_file.h"
#include "render/render_text.h"
#include "rewrite/rewriting.h"
#include "support/folders.h"

namespace pbrt::test {
namespace {

namespace fs = std::filesystem;

/// The tokens of a scene, brackets apart, which are the same with and without around one value.
std::vector<std::string> Tokens(const std::string &text) {
    Diagnostics log;
    std::vector<std::string> tokens;
    for (Lexer lexer(text, "test", &log); lexer.Peek().kind != TokenKind::End; lexer.Advance())
        if (lexer.Peek().kind == TokenKind::Word || lexer.Peek().kind == TokenKind::String)
            tokens.emplace_back(lexer.Written());
    EXPECT_FALSE(log.HasErrors());
    return tokens;
}

/// Characters that comments consist of, whatever their places.
size_t CommentBytes(const std::string &text) {
    Diagnostics log;
    size_t bytes = 0;
    for (Lexer lexer(text, "test", &log);; lexer.Advance()) {
        for (const char c : lexer.Before())
            bytes += c != ' ' && c != '\n' && c != '\t' && c != '\r';
        if (lexer.Peek().kind == TokenKind::End) return bytes;
    }
}

std::vector<fs::path> Scenes(std::initializer_list<const char *> folders) {
    std::vector<fs::path> scenes;
    for (const char *const folder : folders)
        for (const auto &entry : fs::recursive_directory_iterator(SourceDir() + folder))
            if (entry.path().extension() == ".pbrt") scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    EXPECT_GT(scenes.size(), 100u);
    return scenes;
}

std::string Contents(const fs::path &path) {
    return ReadWholeFile(path.string(), Pipes::Refused).bytes.value_or("");
}

TEST(Every, FormattedSceneHasTheSameTokensAndComments) {
    for (const fs::path &path :
         Scenes({"/scenes", "/test/conformance/scenes", "/test/render/cases", "/bench"})) {
        SCOPED_TRACE(path);
        const std::string text = Contents(path), formatted = Formatted(text);
        EXPECT_EQ(Tokens(formatted), Tokens(text));
        EXPECT_EQ(CommentBytes(formatted), CommentBytes(text));
        EXPECT_EQ(Formatted(formatted), formatted) << "once more";
        EXPECT_EQ(Rewrite(text, rewrite::Task::Upgrade).text, formatted) << "it is of pbrt-v4";
    }
}

/// One sample a pixel; nullopt where the scene is refused.
std::optional<Image> Picture(const std::string &text, const std::string &dir) {
    Diagnostics log;
    SceneDescription description;
    ParseString(text, "test.pbrt", dir, description, log);
    Overrides overrides;
    overrides.spp = 1;
    const std::optional<RenderTask> task = MakeRenderTask(std::move(description), overrides, log);
    if (!task || log.HasErrors()) return {};
    return RenderAll(*task, 2).image;
}

TEST(Every, FormattedSceneGivesTheSamePicture) {
    int rendered = 0;
    for (const fs::path &path : Scenes({"/test/conformance/scenes", "/test/render/cases"})) {
        SCOPED_TRACE(path);
        const std::string text = Contents(path), dir = path.parent_path().string();
        const auto before = Picture(text, dir), after = Picture(Formatted(text), dir);
        ASSERT_EQ(before.has_value(), after.has_value());
        if (!before) continue;
        EXPECT_TRUE(std::ranges::equal(before->Data(), after->Data()));
        ++rendered;
    }
    EXPECT_GT(rendered, 90);
}

TEST(Format, LaysOutBlocksParametersAndComments) {
    EXPECT_EQ(Formatted(R"(# head


# more
Camera "perspective" "float fov" 40 # wide
  # the shutter
  "float shutteropen" [ 0 # opens
  ] # behind
WorldBegin AttributeBegin  # a box
Shape"sphere"#ball
  "float radius" .5
AttributeEnd
ObjectBegin "o"
  Translate 1 0 0
  # nothing

ObjectEnd
# end)"),
              R"(# head

# more
Camera "perspective"
    "float fov" [ 40 ]  # wide
    # the shutter
    # opens
    "float shutteropen" [ 0 ]  # behind

WorldBegin

AttributeBegin  # a box
    Shape "sphere"  #ball
        "float radius" [ .5 ]
AttributeEnd

ObjectBegin "o"
    Translate 1 0 0
    # nothing

ObjectEnd
# end
)");
}

TEST(Format, LongListsAreBroken) {
    std::string list;
    for (int i = 0; i < 100; ++i)
        list += " 0.125";
    const std::string text = Formatted("Shape \"curve\" \"point3 P\" [" + list + " ]");
    for (size_t i = 0; i < text.size(); i = std::min(text.find('\n', i), text.size() - 1) + 1)
        EXPECT_LE(std::min(text.find('\n', i), text.size()) - i, 100u);
    EXPECT_EQ(Tokens(text).size(), 103u);
}

TEST(Format, TakesTheSpellingsOfPbrtV3ThatUpstreamTakes) {
    EXPECT_EQ(Formatted("LightSource \"point\" \"point from\" [ 0 1 0 ]\n\"color I\" [ 1 1 1 ]\n"
                        "Shape \"curve\" \"bool flat\" \"true\"\nWorldEnd # over"),
              "LightSource \"point\"\n    \"point3 from\" [ 0 1 0 ]\n    \"rgb I\" [ 1 1 1 ]\n"
              "Shape \"curve\" \"bool flat\" [ true ]\n# over\n");
}

TEST(Format, IncludesStay) {
    EXPECT_EQ(Formatted("Include \"none.pbrt\"\nImport \"none.pbrt.gz\""),
              "Include \"none.pbrt\"\nImport \"none.pbrt.gz\"\n");
}

TEST(Format, MistakesAreToldWithTheirPlace) {
    const auto says = [](const std::string &text) {
        const Rewritten r = Rewrite(text, rewrite::Task::Format);
        EXPECT_EQ(r.text, "") << text;
        return r.messages;
    };
    EXPECT_EQ(says("Identity\n Shap \"sphere\""),
              "test.pbrt:2:2: expected a directive, found \"Shap\"; did you mean \"Shape\"?\n");
    EXPECT_EQ(says("Shape sphere"),
              "test.pbrt:1:7: expected a name in quotes after Shape, found \"sphere\"\n");
    EXPECT_EQ(
        says("Shape \"sphere\" \"radius\" 1"),
        "test.pbrt:1:16: expected a parameter's \"type name\", found the string \"radius\"\n");
    EXPECT_EQ(says("Shape \"sphere\" \"float radius\""),
              "test.pbrt:1:30: expected a value, found the end of the file\n");
    EXPECT_EQ(says("Shape \"sphere\" \"float radius\" [ 1\nIdentity"),
              "test.pbrt:2:1: expected a value or \"]\", found \"Identity\"\n");
    EXPECT_EQ(says("Shape \"sphere"),
              "test.pbrt:1:7: the string \"sphere\" is not closed before the end of its file\n");
}

}  // namespace
}  // namespace pbrt::test
