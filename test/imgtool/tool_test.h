#pragma once

#include "pbrt/image/image.h"
#include "pbrt/imgtool/commands.h"
#include "support/temp_folder.h"

namespace pbrt::imgtool {

/// Runs imgtool in a folder of its own.
class ToolTest : public TempFolder {
  protected:
    static Outcome Do(const std::vector<std::string> &args) { return cli::Run(kTool, args); }
    /// As Do, where success is expected.
    static std::string Succeed(const std::vector<std::string> &args) {
        const Outcome outcome = cli::Run(kTool, args);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }
    /// The message of a command that fails.
    static std::string Fail(const std::vector<std::string> &args) {
        const Outcome outcome = cli::Run(kTool, args);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.out;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    }
    std::string Save(const std::string &name, const Image &image) const {
        EXPECT_EQ(WriteImage(image, Path(name), ExrPixels::Float), std::nullopt);
        return Path(name);
    }
    static Image Load(const std::string &path) {
        const OrError<Image> image = ReadImage(path);
        EXPECT_TRUE(image) << image.error;
        return image.value.value_or(Image({1, 1}, {"none"}));
    }
    /// A picture of these values.
    static Image Picture(Point2i size, std::vector<std::string> channels,
                         std::vector<float> values) {
        Image image(size, std::move(channels));
        EXPECT_EQ(values.size(), image.Data().size());
        image.Data() = std::move(values);
        return image;
    }
    static inline const std::vector<std::string> kRGB{"R", "G", "B"};
};

}  // namespace pbrt::imgtool
