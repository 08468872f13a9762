#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "pbrt/image/image.h"
#include "pbrt/imgtool/commands.h"

namespace pbrt::imgtool {

/// The user's mistake: "imgtool: reason" and exit code 1.
Outcome Failure(std::string_view reason);

/// Fills the variables bound to `app`'s options, spelled as pbrt allows. Something is returned
/// where the command ends here: help, or a mistake.
std::optional<Outcome> Parse(CLI::App *app, Args args);

/// `--crop x0,x1,y0,y1`, `--channels R,G,B`: shared by several commands.
void AddCrop(CLI::App *app, std::vector<int> *crop);
void AddChannels(CLI::App *app, std::vector<std::string> *channels);
void AddOutfile(CLI::App *app, std::string *outfile);

/// Writes, or says why not.
Outcome Write(const Image &image, const std::string &fileName, ExrPixels pixels);

}  // namespace pbrt::imgtool
