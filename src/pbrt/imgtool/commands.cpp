#include "pbrt/imgtool/commands.h"

#include <array>

namespace pbrt::imgtool {
namespace {

constexpr std::array kCommands{
    cli::Command{"assemble", "join crops to the full picture, what is missing black", Assemble},
    cli::Command{"average", "mean of several pictures by their samples, and its variance", Average},
    cli::Command{"check", "test that a picture is finite, not black, and changes its hue", Check},
    cli::Command{"convert", "change a picture's format, size, colors or values", Convert},
    cli::Command{"diff", "compare a picture with a reference", Diff},
    cli::Command{"error", "expected error of one of several independent renderings", Error},
    cli::Command{"info", "size, metadata and range of values", Info},
    cli::Command{"makeequiarea", "latitude-longitude environment to a square equal-area one",
                 MakeEquiArea},
    cli::Command{"merge", "join crops and ranges of samples of one render, exactly", Merge},
};

}  // namespace

const cli::Tool kTool{"imgtool", "<command> [options] files...", kCommands};

}  // namespace pbrt::imgtool
