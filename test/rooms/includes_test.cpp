#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/folders.h"
#include "support/shell.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

Outcome Check(const std::string &rooms) {
    return Shell("sh '" + SourceDir() + "/test/rooms/check_includes.sh' '" + rooms + "'");
}

TEST(Rooms, IncludeWhatTheyDeclare) {
    const Outcome outcome = Check(SourceDir() + "/src/pbrt");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.said;
}

/// A small house that keeps all rules.
class BrokenRooms : public TempFolder {
  protected:
    void SetUp() override {
        TempFolder::SetUp();
        Add("CMakeLists.txt",
            "add_subdirectory(simd)\nadd_subdirectory(feather)\nadd_subdirectory(util)\n"
            "add_subdirectory(shapes)\nadd_subdirectory(accel)\nadd_subdirectory(integrators)\n"
            "add_subdirectory(cmd)\n");
        Add("util/CMakeLists.txt", "pbrt_room(util DEPS pbrt_feather fmt::fmt)\n");
        Add("shapes/CMakeLists.txt", "pbrt_room(shapes DEPS pbrt_util)\n");
        Add("accel/CMakeLists.txt", "pbrt_room(accel DEPS pbrt_shapes\n           embree)\n");
        Add("integrators/CMakeLists.txt", "pbrt_room(integrators DEPS pbrt_accel)\n");
        Add("cmd/CMakeLists.txt", "target_link_libraries(${name} PRIVATE pbrt_integrators)\n");
        Add("simd/simd.h", "#include <cmath>\n#include <immintrin.h>\n");
        Add("feather/arc.h",
            "#include <cmath>\n#include \"units.h\"\n"
            "#include \"../simd/simd.h\"\n");
        Add("util/range.h", "#include <fmt/format.h>\n#include \"pbrt/feather/arc.h\"\n");
        Add("shapes/disk.h", "// As Embree has it.\n#include \"pbrt/util/range.h\"\n");
        Add("accel/accel.h", "#include <embree3/rtcore.h>\n#include \"pbrt/shapes/disk.h\"\n");
        Add("integrators/path/path.h", "#include \"pbrt/accel/accel.h\"\n");
        Add("integrators/walk/walk.h", "#include \"pbrt/feather/arc.h\"\n");
        Add("cmd/pbrt.cpp", "#include \"pbrt/integrators/path/path.h\"\n");
        ASSERT_EQ(Check(folder.string()).said, "");
    }
    void Add(const std::string &name, const std::string &text) const {
        std::filesystem::create_directories((folder / name).parent_path());
        Put(name, text);
    }
    /// One complaint, of these words.
    void ExpectComplaint(const std::string &words) const {
        const Outcome outcome = Check(folder.string());
        EXPECT_NE(outcome.exitCode, 0);
        EXPECT_EQ(outcome.said, words + "\n");
    }
};

TEST_F(BrokenRooms, ALaterRoom) {
    Add("shapes/disk.h", "#include \"pbrt/util/range.h\"\n#include \"pbrt/accel/accel.h\"\n");
    ExpectComplaint("shapes/disk.h:2: shapes includes accel, which CMakeLists.txt lists later");
}

TEST_F(BrokenRooms, ARoomThatIsNotDeclared) {
    Add("util/CMakeLists.txt", "pbrt_room(util DEPS fmt::fmt)\n");
    Add("integrators/walk/walk.h", "");
    ExpectComplaint("util/range.h:2: util includes feather, which its DEPS do not declare");
}

TEST_F(BrokenRooms, ADependencyThatNothingUses) {
    Add("accel/accel.h", "");
    ExpectComplaint("accel/CMakeLists.txt:1: accel declares shapes and includes nothing of it");
}

TEST_F(BrokenRooms, ADependencyListedLater) {
    Add("shapes/CMakeLists.txt", "pbrt_room(shapes DEPS pbrt_util\n           pbrt_cmd)\n");
    ExpectComplaint("shapes/CMakeLists.txt:2: shapes declares cmd, which is not listed before it");
}

TEST_F(BrokenRooms, AnUnlistedRoom) {
    Add("shed/spade.h", "#include \"pbrt/util/range.h\"\n");
    ExpectComplaint("shed/spade.h:1: room shed is not listed in CMakeLists.txt");
}

TEST_F(BrokenRooms, AnIntegratorIncludedByAnother) {
    Add("integrators/walk/walk.h", "#include \"pbrt/integrators/path/path.h\"\n");
    ExpectComplaint("integrators/walk/walk.h:1: integrator walk includes another, path");
}

TEST_F(BrokenRooms, NamesOfEmbree) {
    Add("cmd/pbrt.cpp",
        "#include \"pbrt/integrators/path/path.h\"\n"
        "void F() { rtcReleaseScene(s); }  // Embree\n");
    ExpectComplaint("cmd/pbrt.cpp:2: names Embree, which accel/ alone may");
}

TEST_F(BrokenRooms, AModelThatNeedsMoreThanTheStandardLibrary) {
    for (const std::string include : {"<fmt/format.h>", "\"pbrt/util/range.h\"", "<cairo.h>"}) {
        Add("feather/arc.h", "#include " + include + "\n");
        ExpectComplaint("feather/arc.h:1: feather includes " + include +
                        ", but only itself, simd and the standard library are allowed");
    }
}

TEST_F(BrokenRooms, AnIncludeWithoutItsRoom) {
    Add("accel/accel.h", "#include \"query.h\"\n#include \"pbrt/shapes/disk.h\"\n");
    ExpectComplaint(
        "accel/accel.h:1: \"query.h\" in quotes is not of the form "
        "\"pbrt/<room>/<file>.h\"");
}

}  // namespace
}  // namespace pbrt
