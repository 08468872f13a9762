// Less and less address space: the right picture or a sentence, and then the old picture stays.

#include <fmt/format.h>

#include <array>

#include "faults/faults.h"
#include "pbrt/image/image.h"

namespace pbrt::test {
namespace {

class FaultsOfMemory : public Faults {
  protected:
    /// Renders scene.pbrt with ever more address space, from what the program's own code takes,
    /// until there is enough. `step` is the factor from limit to limit.
    void Loop(const std::vector<std::string> &more, double step = 1.07) const {
        ASSERT_TRUE(Ended(Render({}, more)));
        const std::string right = Get("out.pfm");
        const std::vector<std::string> files = Files();
        ASSERT_FALSE(right.empty());
        const std::string old = "the old picture";
        int refused = 0;
        for (double bytes = 60e6;; bytes *= step) {
            ASSERT_LT(bytes, 8e9);
            Put("out.pfm", old);
            const Outcome outcome = Render({uint64_t(bytes), 0, {}}, more);
            EXPECT_EQ(Files(), files) << bytes;
            if (outcome.exitCode == 0) {
                EXPECT_TRUE(Get("out.pfm") == right) << bytes << ": another picture";
                break;
            }
            // The loader of shared libraries has its own exit code and sentence.
            const bool isLoader = outcome.exitCode == 127;
            EXPECT_TRUE(isLoader || Refused(outcome)) << bytes;
            EXPECT_EQ(Get("out.pfm"), old) << bytes;
            refused += !isLoader;
        }
        EXPECT_GT(refused, 0) << "no limit was met";
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
    Loop({"--nthreads", "1"});
    Loop({"--nthreads", "2"});
}

TEST_F(FaultsOfMemory, Instances) {
    SKIP_WHERE_SANITIZED();
    std::string text = "ObjectBegin \"o\" Shape \"sphere\" \"float radius\" .01 ObjectEnd\n";
    for (int i = 0; i < 60000; ++i)
        text += fmt::format("Translate {:.4f} {:.4f} 0 ObjectInstance \"o\"\n",
                            0.01 * ((i * 7) % 5 - 2), 0.01 * ((i * 3) % 5 - 2));
    PutScene(text);
    Loop({"--nthreads", "2"});
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
    Loop({"--nthreads", "2"});
}

TEST_F(FaultsOfMemory, Texture) {
    SKIP_WHERE_SANITIZED();
    ASSERT_EQ(WriteImage(Image({2000, 2000}, {"R", "G", "B"}), Path("t.exr"), ExrPixels::Half),
              std::nullopt);
    PutScene(
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"t.exr\"\n"
        "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"");
    Loop({"--nthreads", "2"});
}

}  // namespace
}  // namespace pbrt::test
