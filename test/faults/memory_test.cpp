// Less and less address space: the right picture or a sentence, and then the old picture stays.

#include <fmt/format.h>

#include <array>

#include "faults/faults.h"
#include "pbrt/image/image.h"

namespace pbrt::test {
namespace {

class FaultsOfMemory : public Faults {
  protected:
    /// Bytes, or a picture's values: an EXR file says how long it was rendered.
    using Contents = std::pair<std::string, std::vector<float>>;
    Contents Read(const std::string &name) const {
        if (!name.ends_with(".exr")) return {Get(name), {}};
        const OrError<Image> image = ReadImage(Path(name));
        return {image.error, image ? image.value->Data() : std::vector<float>()};
    }
    /// False where the program's own code is never reached: the loader of shared libraries gives up
    /// (exit code 127, with a sentence), or a library's constructor dies, as that of oneTBB 2022,
    /// which does not look at what its allocator returns (139; in a window 2 MB wide).
    bool Starts(const std::string &program, double bytes) const {
        return Run(program, {"--version"}, {.addressSpace = uint64_t(bytes)}).exitCode == 0;
    }
    /// Runs the program with ever more address space, from what its own code takes, until there is
    /// enough; `step` is the factor from limit to limit. Outputs that fail stay as they were.
    void Loop(const std::string &program, const std::vector<std::string> &args,
              const std::vector<std::string> &outputs, double step) const {
        const Outcome unlimited = Run(program, args);
        ASSERT_EQ(unlimited.exitCode, 0) << unlimited.said;
        const std::vector<std::string> files = Files();
        std::vector<Contents> right;
        for (const std::string &name : outputs)
            right.push_back(Read(name));
        const std::string old = "the old one";
        for (double bytes = 50e6;; bytes *= step) {
            ASSERT_LT(bytes, 8e9);
            for (const std::string &name : outputs)
                Put(name, old);
            const Outcome outcome = Run(program, args, {.addressSpace = uint64_t(bytes)});
            EXPECT_EQ(Files(), files) << bytes;
            EXPECT_TRUE(Ended(outcome) || !Starts(program, bytes)) << bytes;
            for (size_t i = 0; i < outputs.size(); ++i)
                EXPECT_TRUE(outcome.exitCode == 0 ? Read(outputs[i]) == right[i]
                                                  : Get(outputs[i]) == old)
                    << outputs[i] << ", " << bytes << " bytes: exit code " << outcome.exitCode;
            if (outcome.exitCode == 0) break;
        }
    }
    /// The same for pbrt and scene.pbrt.
    void Loop(const char *nThreads, double step = 1.15, const std::string &out = "out.pfm") const {
        Loop("pbrt", {"scene.pbrt", "--quiet", "--nthreads", nThreads, "--outfile", out}, {out},
             step);
    }
    /// A grid of n x n points.
    void PutMesh(int n) const {
        std::string ply = fmt::format(
            "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\n"
            "property float y\nproperty float z\nelement face {}\n"
            "property list uchar int vertex_indices\nend_header\n",
            n * n, 2 * (n - 1) * (n - 1));
        const auto put = [&](auto value) {
            ply.append(reinterpret_cast<const char *>(&value), sizeof value);
        };
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                put(2 * float(x) / float(n - 1) - 1);
                put(2 * float(y) / float(n - 1) - 1);
                put(0.1f * float((x * 7 + y * 3) % 11) / 11);
            }
        for (int y = 0; y + 1 < n; ++y)
            for (int x = 0; x + 1 < n; ++x) {
                const int a = y * n + x;
                for (const std::array<int, 3> &t :
                     {std::array{a, a + 1, a + n}, std::array{a + 1, a + n + 1, a + n}}) {
                    put(static_cast<unsigned char>(3));
                    for (int corner : t)
                        put(corner);
                }
            }
        Put("mesh.ply", ply);
    }
};

TEST_F(FaultsOfMemory, Mesh) {
    SKIP_WHERE_SANITIZED();
    PutMesh(400);
    PutScene(
        "Material \"diffuse\" \"rgb reflectance\" [.2 .2 .2]\n"
        "Shape \"plymesh\" \"string filename\" \"mesh.ply\"");
    Loop("1", 1.08);
    Loop("2");
}

TEST_F(FaultsOfMemory, Instances) {
    SKIP_WHERE_SANITIZED();
    std::string text = "ObjectBegin \"o\" Shape \"sphere\" \"float radius\" .01 ObjectEnd\n";
    for (int i = 0; i < 60000; ++i)
        text += fmt::format("Translate {:.4f} {:.4f} 0 ObjectInstance \"o\"\n",
                            0.01 * ((i * 7) % 5 - 2), 0.01 * ((i * 3) % 5 - 2));
    PutScene(text);
    Loop("2");
}

TEST_F(FaultsOfMemory, Curves) {
    SKIP_WHERE_SANITIZED();
    std::string text;
    for (int i = 0; i < 20000; ++i)
        text += fmt::format(
            "Shape \"curve\" \"point3 P\" [{0:.3f} -1 0 {0:.3f} -.3 .1 {0:.3f} .3 -.1 {0:.3f} 1 0] "
            "\"float width\" .001\n",
            -1 + i * 1e-4);
    PutScene(text);
    Loop("2");
}

TEST_F(FaultsOfMemory, Texture) {
    SKIP_WHERE_SANITIZED();
    ASSERT_EQ(WriteImage(Image({1000, 1000}, {"R", "G", "B"}), Path("t.exr"), ExrPixels::Half),
              std::nullopt);
    PutScene(
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"t.exr\"\n"
        "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"");
    Loop("2");
}

/// What is written takes memory, too.
TEST_F(FaultsOfMemory, Film) {
    SKIP_WHERE_SANITIZED();
    Put("scene.pbrt",
        "Film \"spectral\" \"integer xresolution\" 300 \"integer yresolution\" 300 "
        "\"integer nbuckets\" 64\n"
        "Sampler \"independent\" \"integer pixelsamples\" 1\nWorldBegin\n");
    Loop("2", 1.15, "out.exr");
}

TEST_F(FaultsOfMemory, Tools) {
    SKIP_WHERE_SANITIZED();
    ASSERT_EQ(WriteImage(Image({1000, 1000}, {"R", "G", "B"}), Path("t.exr"), ExrPixels::Half),
              std::nullopt);
    Loop("imgtool", {"convert", "t.exr", "--outfile", "out.png"}, {"out.png"}, 1.15);
    Loop("bsdftool", {"plot", "Material \"diffuse\"", "--png", "s.png"}, {"s.png"}, 1.15);
}

/// One of many files may be new when the next fails.
TEST_F(FaultsOfMemory, Feathergen) {
    SKIP_WHERE_SANITIZED();
    for (double bytes = 50e6;; bytes *= 1.15) {
        const Outcome outcome =
            Run("feathergen", {"--out", "feather"}, {.addressSpace = uint64_t(bytes)});
        EXPECT_TRUE(Ended(outcome) || outcome.exitCode == 127) << bytes;
        if (outcome.exitCode == 0) break;
        EXPECT_TRUE(Files().empty()) << bytes;
    }
}

}  // namespace
}  // namespace pbrt::test
