#pragma once

#include <string>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/imgtool/commands.h"

// Options that several commands share, and the image they write.

namespace pbrt::imgtool {

/// `--crop x0,x1,y0,y1` and `--channels R,G,B`.
void AddCrop(CLI::App *app, std::vector<int> *crop);
void AddChannels(CLI::App *app, std::vector<std::string> *channels);
/// `--outfile`, required.
void AddOutfile(CLI::App *app, std::string *outfile);
/// `--reference`, required, and `--metric`, which `metrics` lists.
void AddComparison(CLI::App *app, std::string *reference, std::string *metric,
                   const std::string &metrics = "MSE (default), MAE or MRSE");

/// The outcome with remarks, lines of their own, before what it says of mistakes.
Outcome Remarking(const std::string &remarks, Outcome outcome);

/// Writes, or says why not.
Outcome Write(const Image &image, const std::string &fileName, ExrPixels pixels);

}  // namespace pbrt::imgtool
