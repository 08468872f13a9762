#pragma once

#include <string>
#include <vector>

#include "pbrt/cli/tool.h"
#include "pbrt/image/image.h"
#include "pbrt/util/result.h"
#include "support/temp_folder.h"

namespace pbrt {

/// Runs a tool in a folder of its own.
template <const cli::Tool &tool>
class ToolFolder : public TempFolder {
  protected:
    static cli::Outcome Do(const std::vector<std::string> &args) { return cli::Run(tool, args); }
    /// As Do, where success is expected.
    static std::string Succeed(const std::vector<std::string> &args) {
        const cli::Outcome outcome = Do(args);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }
    /// The message of a command that fails.
    static std::string Fail(const std::vector<std::string> &args) {
        const cli::Outcome outcome = Do(args);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.out;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    }
    static Image Load(const std::string &path) {
        const OrError<Image> image = ReadImage(path);
        EXPECT_TRUE(image) << image.error;
        return image.value.value_or(Image({1, 1}, {"none"}));
    }
};

}  // namespace pbrt
