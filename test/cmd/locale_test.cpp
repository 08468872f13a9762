// The programs under a locale that writes 1,5: numbers in options, scenes, JSON and CSV stay 1.5.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "pbrt/util/read_file.h"
#include "support/folders.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

namespace fs = std::filesystem;

class GermanPrograms : public TempFolder {
  protected:
    bool Do(const std::string &command) const {
        return std::system(("cd '" + folder.string() + "' && " + command).c_str()) == 0;
    }
    /// All files that the programs make in the folder `name`.
    std::string Files(const std::string &name, const std::string &environment) const {
        const std::string programs = ProgramDir() + "/";
        const std::string before =
            "mkdir " + name + " && cd " + name + " && " + environment + " '" + programs;
        EXPECT_TRUE(Do(before + "pbrt' ../a.pbrt --cropwindow=0,0.5,0,1 --outfile a.pfm --quiet"));
        const std::string again = "cd " + name + " && " + environment + " '" + programs;
        EXPECT_TRUE(Do(again + "imgtool' convert a.pfm --exposure 1.5 --outfile b.pfm"));
        EXPECT_TRUE(Do(again + "imgtool' info b.pfm > info.txt"));
        EXPECT_TRUE(Do(again + "feathergen' --print-preset > p.json"));
        EXPECT_TRUE(Do(
            again + "feathergen' --params p.json --set barb_count=4 --set aspect=0.375 --out f"));
        EXPECT_TRUE(Do(again + "bsdftool' spectrum ../a.pbrt --csv s.csv > s.txt"));
        std::string all;
        std::vector<fs::path> files;
        for (const auto &entry : fs::recursive_directory_iterator(folder / name))
            if (entry.is_regular_file()) files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        for (const fs::path &file : files)
            all += file.filename().string() + "\n" + *ReadWholeFile(file.string()).bytes;
        return all;
    }
};

TEST_F(GermanPrograms, ReadAndWriteTheSame) {
    const bool made = Do("localedef -i de_DE -f UTF-8 ./de_DE.UTF-8 2>/dev/null");
    if (!made) GTEST_SKIP() << "no localedef, or no German to make a locale of";
    Put("a.pbrt",
        "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 4\n"
        "Sampler \"independent\" \"integer pixelsamples\" 1\n"
        "WorldBegin LightSource \"infinite\" \"float scale\" 1.25\n"
        "Material \"featherbarbule\" \"float thickness\" 540.5\nTranslate 0 0 2.5\n"
        "Shape \"sphere\"\n");
    const std::string locale = "LOCPATH='" + folder.string() + "' LC_ALL=de_DE.UTF-8";
    ASSERT_TRUE(Do(locale + " locale decimal_point | grep -qx ,"));
    EXPECT_EQ(Files("german", locale), Files("usual", "LC_ALL=C"));
}

/// Programs start in the locale "C", which is what keeps the C functions of libraries to points.
TEST(Sources, NeverSetALocale) {
    for (const auto &entry : fs::recursive_directory_iterator(SourceDir() + "/src")) {
        if (!entry.is_regular_file()) continue;
        const std::string text = *ReadWholeFile(entry.path().string()).bytes;
        for (const char *word : {"setlocale", "std::locale", "imbue", "uselocale"})
            EXPECT_EQ(text.find(word), std::string::npos) << entry.path() << " has " << word;
    }
}

}  // namespace
}  // namespace pbrt
