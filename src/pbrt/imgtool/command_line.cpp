#include "pbrt/imgtool/command_line.h"

namespace pbrt::imgtool {

void AddCrop(CLI::App *app, std::vector<int> *crop) {
    app->add_option("--crop", *crop,
                    "x0,x1,y0,y1: use these pixels only; a negative x1 or y1 is "
                    "an extent")
        ->delimiter(',')
        ->expected(4);
}

void AddChannels(CLI::App *app, std::vector<std::string> *channels) {
    app->add_option("--channels", *channels, "comma-separated names: use these channels only")
        ->delimiter(',');
}

void AddOutfile(CLI::App *app, std::string *outfile) {
    app->add_option("--outfile", *outfile, "picture to write (.exr, .png, .pfm)")->required();
}

void AddComparison(CLI::App *app, std::string *reference, std::string *metric) {
    app->add_option("--reference", *reference, "what the picture should be")->required();
    app->add_option("--metric", *metric, "MSE (default), MAE or MRSE");
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
