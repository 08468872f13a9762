// Numbers mean the same where a program that uses these rooms has set another locale.

#include <clocale>
#include <locale>
#include <sstream>

#include "pbrt/imgtool/commands.h"
#include "pbrt/util/read_file.h"
#include "render/render_text.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

/// As in German: 1.234,5.
struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// Every standard stream made from here on writes commas, as do C functions where the system has
/// such a locale.
class WithCommas {
  public:
    WithCommas() : before(std::locale::global(std::locale(std::locale(), new Commas))) {
        for (const char *name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "pl_PL.UTF-8"})
            if (std::setlocale(LC_NUMERIC, name)) return;
    }
    ~WithCommas() {
        std::locale::global(before);
        std::setlocale(LC_NUMERIC, "C");
    }

  private:
    std::locale before;
};

class Locale : public TempFolder {
  protected:
    /// Everything that comes from numbers in files: a scene, a measurement, a mesh, a picture, and
    /// what is said of it.
    std::string Everything() const {
        Put("m.txt", "400 0.25\n700 0.75\n1234.5 .5\n");
        Put("m.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
            "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n-1.5 -1.5 1.5e-400\n1.5 -1.5 0\n1.5 1.5 0\n-1.5 1.5e0 0.0\n4 0 1 2 3\n");
        const Image image = RenderText(
            "LookAt 0 0 2.5  0 0 0  0 1 0\nFilm \"rgb\" \"integer xresolution\" 1234 \"integer "
            "yresolution\" 2\nSampler \"independent\" \"integer pixelsamples\" 1\n"
            "WorldBegin LightSource \"infinite\" \"float scale\" 1.25\n"
            "Material \"diffuse\" \"spectrum reflectance\" \"m.txt\"\n"
            "Shape \"plymesh\" \"string filename\" \"m.ply\"\n",
            {.nThreads = 1}, folder.string());
        EXPECT_EQ(WriteImage(image, Path("a.pfm")), std::nullopt);
        const std::vector<std::string> args{"info", Path("a.pfm")};
        const cli::Outcome info = cli::Run(imgtool::kTool, args);
        return *ReadWholeFile(Path("a.pfm")).bytes + info.out + info.err;
    }
};

TEST_F(Locale, ChangesNoNumber) {
    const std::string usual = Everything();
    const WithCommas commas;
    std::ostringstream proof;
    proof << 1234.5;
    ASSERT_EQ(proof.str(), "1.234,5");
    EXPECT_EQ(Everything(), usual);
}

}  // namespace
}  // namespace pbrt::test
