#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "faults/process.h"
#include "support/sanitized.h"
#include "support/temp_folder.h"

namespace pbrt::test {

/// Programs run in a folder of their own; see TempFolder for Path and Put.
class Faults : public TempFolder {
  protected:
    void SetUp() override {
        TempFolder::SetUp();
        // Where a test runs programs as another user.
        std::filesystem::permissions(folder, std::filesystem::perms::all);
    }

    Outcome Run(const std::string &program, const std::vector<std::string> &args,
                const Limits &limits = {}) const {
        return Process(program, args, folder, limits).Wait();
    }
    /// Renders scene.pbrt to out.pfm.
    Outcome Render(const Limits &limits = {}, const std::vector<std::string> &more = {}) const {
        std::vector<std::string> args{"scene.pbrt", "--quiet", "--outfile", "out.pfm"};
        args.insert(args.end(), more.begin(), more.end());
        return Run("pbrt", args, limits);
    }
    /// scene.pbrt: size x size pixels of 4 samples under an even sky, the camera at z = 3 looking
    /// to the origin.
    void PutScene(const std::string &directives, int size = 16) const {
        const std::string n = std::to_string(size);
        Put("scene.pbrt",
            "Film \"rgb\" \"integer xresolution\" " + n + " \"integer yresolution\" " + n +
                "\nSampler \"independent\" \"integer pixelsamples\" 4\n"
                "LookAt 0 0 3 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\nWorldBegin\n"
                "LightSource \"infinite\"\n" +
                directives + "\n");
    }
    std::string Get(const std::string &name) const {
        std::ifstream file(Path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// Names of the files, sorted.
    std::vector<std::string> Files() const {
        std::vector<std::string> names;
        for (const auto &entry : std::filesystem::directory_iterator(folder))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    /// A sentence and exit code 1.
    static testing::AssertionResult Refused(const Outcome &o, const std::string &sentence = "") {
        if (o.exitCode == 1 && !o.said.empty() && o.said.find(sentence) != std::string::npos)
            return testing::AssertionSuccess();
        return Told(o);
    }
    /// Refused, or success.
    static testing::AssertionResult Ended(const Outcome &o) {
        return o.exitCode == 0 ? testing::AssertionSuccess() : Refused(o);
    }

  private:
    static testing::AssertionResult Told(const Outcome &o) {
        return testing::AssertionFailure() << "exit code " << o.exitCode << ", signal " << o.signal
                                           << (o.tooLong ? ", too long" : "") << ": " << o.said;
    }
};

/// Left out of sanitizer builds.
#define SKIP_WHERE_SANITIZED() \
    if (kSanitized) GTEST_SKIP() << "sanitizers take more address space than any limit"

}  // namespace pbrt::test
