#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "pbrt/image/image.h"
#include "support/folders.h"
#include "support/shell.h"
#include "support/temp_folder.h"

namespace pbrt::test {

/// Programs run in a folder of their own.
class ProgramFolder : public TempFolder {
  protected:
    /// `command` begins with a program's name.
    Outcome Run(const std::string &command) const {
        return Shell("cd '" + Path("") + "' && PATH='" + ProgramDir() + "':\"$PATH\" " + command);
    }
    /// Expects success; what was said.
    std::string Succeed(const std::string &command) const {
        const Outcome outcome = Run(command);
        EXPECT_EQ(outcome.exitCode, 0) << command << ": " << outcome.said;
        return outcome.said;
    }
    /// Expects exit code 1 and this among what is said.
    void Refuses(const std::string &command, const std::string &what) const {
        const Outcome outcome = Run(command);
        EXPECT_EQ(outcome.exitCode, 1) << command;
        EXPECT_NE(outcome.said.find(what), std::string::npos) << command << ": " << outcome.said;
    }
    std::string Get(const std::string &name) const {
        std::ifstream file(Path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    bool IsThere(const std::string &name) const { return std::filesystem::exists(Path(name)); }
    Image Load(const std::string &name) const {
        OrError<Image> image = ReadImage(Path(name));
        EXPECT_TRUE(image) << image.error;
        return image.value.value_or(Image({1, 1}, {"none"}));
    }
    /// A ball on a sky, 40 x 24 pixels, 128 samples. `film`: type and parameters.
    void PutBall(const std::string &film, const std::string &more = "") const {
        Put("ball.pbrt",
            "Film " + film +
                " \"integer xresolution\" 40 \"integer yresolution\" 24\n"
                "Sampler \"independent\" \"integer pixelsamples\" 128\n"
                "LookAt 0 0 3 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\nWorldBegin\n"
                "LightSource \"infinite\" \"rgb L\" [ .3 .5 .7 ]\nMaterial \"featherbarbule\"\n"
                "Shape \"sphere\"\n" +
                more);
    }
};

}  // namespace pbrt::test
