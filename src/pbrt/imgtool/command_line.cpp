#include "pbrt/imgtool/command_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/util/args.h"

namespace pbrt::imgtool {

Outcome Failure(std::string_view reason) {
    return {1, {}, fmt::format("imgtool: {}\n", reason)};
}

std::optional<Outcome> Parse(CLI::App *app, Args args) {
    NormalizedArgs normalized = NormalizeArgs(args, ArgOptionsOf(*app));
    const auto mistake = [&](std::string_view text) {
        return Outcome{1,
                       {},
                       fmt::format("{}: {}\n(\"{} --help\" lists the options)\n", app->get_name(),
                                   text, app->get_name())};
    };
    if (!normalized.error.empty()) return mistake(normalized.error);
    std::reverse(normalized.args.begin(), normalized.args.end());  // CLI11 takes them from the back
    try {
        app->parse(normalized.args);
    } catch (const CLI::CallForHelp &) {
        return Outcome{0, app->help(), {}};
    } catch (const CLI::ParseError &e) {
        return mistake(e.what());
    }
    return {};
}

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

Outcome Write(const Image &image, const std::string &fileName, ExrPixels pixels) {
    if (auto reason = WriteImage(image, fileName, pixels)) return Failure(*reason);
    return {};
}

}  // namespace pbrt::imgtool
