#pragma once

#include <optional>
#include <string>

#include "pbrt/pbrt/command_line.h"

namespace pbrt::program {

/// The outcome of a frame.
struct FrameResult {
    int exitCode = 0;
    bool skipped = false;  ///< its picture was there
    std::string picture;   ///< the file's name, where it is known
};

/// Parses, builds and renders a picture and writes it. `threadRemark`: a warning to print with
/// those of the scene. `frame`: its number, with --frames; `previous` the picture of the frame
/// before.
FrameResult RenderFrame(const Arguments &arguments, const std::optional<std::string> &threadRemark,
                        std::optional<int> frame = {}, const std::string &previous = {});

}  // namespace pbrt::program
