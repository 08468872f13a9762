#pragma once

#include "pbrt/image/image.h"
#include "pbrt/imgtool/commands.h"
#include "support/tool_test.h"

namespace pbrt::imgtool {

class ToolTest : public ToolFolder<kTool> {
  protected:
    std::string Save(const std::string &name, const Image &image) const {
        EXPECT_EQ(WriteImage(image, Path(name), ExrPixels::Float), std::nullopt);
        return Path(name);
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
