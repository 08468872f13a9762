#include "pbrt/imgtool/command_line.h"

#include "pbrt/cli/options.h"

namespace pbrt::imgtool {

void AddCrop(CLI::App *app, std::vector<int> *crop) {
    constexpr int kFar = 1 << 24;  // farther than any image reaches
    cli::AddNumbers(app, "--crop", crop, "x0,x1,y0,y1", {.lo = -kFar, .hi = kFar},
                    "use these pixels only; a negative x1 or y1 is an extent");
}

void AddChannels(CLI::App *app, std::vector<std::string> *channels) {
    cli::AddNames(app, "--channels", channels, "R,G,B", "names of channels: use these only");
}

void AddOutfile(CLI::App *app, std::string *outfile) {
    cli::AddRequired(app, "--outfile", outfile, "picture to write (.exr, .png, .pfm)");
}

void AddComparison(CLI::App *app, std::string *reference, std::string *metric,
                   const std::string &metrics) {
    cli::AddRequired(app, "--reference", reference, "what the picture should be");
    cli::AddText(app, "--metric", metric, metrics);
}

Outcome Remarking(const std::string &remarks, Outcome outcome) {
    outcome.err.insert(0, remarks);
    return outcome;
}

Outcome Write(const Image &image, const std::string &fileName, ExrPixels pixels) {
    if (auto reason = WriteImage(image, fileName, pixels)) return Failure(*reason);
    return {};
}

}  // namespace pbrt::imgtool
