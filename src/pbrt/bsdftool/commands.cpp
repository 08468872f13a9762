#include "pbrt/bsdftool/commands.h"

#include <array>

namespace pbrt::bsdftool {
namespace {

constexpr std::array kCommands{
    cli::Command{"eval", "values for pairs of directions, as JSON lines", RunEval},
    cli::Command{"furnace", "what becomes of light, by direction: R, TRT, T, absorbed", RunFurnace},
    cli::Command{"plot", "pictures of the light scattered to either side", RunPlot},
    cli::Command{"spectrum", "reflectance against wavelength and angle", RunSpectrum},
};

}  // namespace

const cli::Tool kTool{"bsdftool", "<command> MATERIAL [options]", kCommands};

}  // namespace pbrt::bsdftool
