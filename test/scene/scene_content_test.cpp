// The content of a scene, as a number.

#include "pbrt/scene/scene_content.h"

#include "support/temp_folder.h"

namespace pbrt {
namespace {

class Content : public TempFolder {
  protected:
    Digest Assets(const std::string &text, const std::vector<std::string> &written = {}) const {
        SceneContent content;
        content.AddText(text, folder.string());
        return content.Assets(written);
    }
};

TEST_F(Content, FilesThatTheTextNamesCount) {
    const std::string text = "Shape \"plymesh\" \"string filename\" \"a.ply\" # \"b.ply\"\n";
    Put("a.ply", "1");
    Put("b.ply", "1");
    const Digest before = Assets(text);
    Put("b.ply", "2");
    EXPECT_EQ(Assets(text), before) << "in a comment";
    Put("a.ply", "2");
    EXPECT_NE(Assets(text), before);
    Put("a.ply", "1");
    EXPECT_EQ(Assets(text), before);
    EXPECT_EQ(Assets(text, {"a.ply"}), Digest{}) << "a file that the scene writes";
}

TEST_F(Content, QuotesAreSeenThrough) {
    Put("a\"b\\c", "1");
    Put("d", "2");
    EXPECT_NE(Assets("\"a\\\"b\\\\c\""), Digest{});
    // A word that is not closed ends with its line.
    EXPECT_EQ(Assets("\"x\n\"d\""), Assets("\"d\""));
    EXPECT_EQ(Assets("\"#\" \"d\""), Assets("\"d\""));
}

TEST_F(Content, TextCountsInItsOrder) {
    SceneContent ab, ba;
    ab.AddText("a", "");
    ab.AddText("b", "");
    ba.AddText("b", "");
    ba.AddText("a", "");
    EXPECT_NE(ab.Text(), ba.Text());
    EXPECT_EQ(ToText(Digest{1, 2}), "00000000000000020000000000000001");
}

}  // namespace
}  // namespace pbrt
