#include "pbrt/imgtool/commands.h"

#include <array>

namespace pbrt::imgtool {
namespace {

constexpr std::array kCommands{
    cli::Command{"assemble", "join crops to the full picture, what is missing black", Assemble},
    cli::Command{"average", "mean of several pictures by their samples, and its variance", Average},
    cli::Command{"bloom", "let bright pixels bleed into their neighbours", Bloom},
    cli::Command{"cat", "print the values of pixels", Cat},
    cli::Command{"check", "test that a picture is finite, not black, and changes its hue", Check},
    cli::Command{"convert", "change a picture's format, size, colors or values", Convert},
    cli::Command{"denoise", "take noise out, by Open Image Denoise", Denoise},
    cli::Command{"diff", "compare a picture with a reference", Diff},
    cli::Command{"error", "expected error of one of several independent renderings", Error},
    cli::Command{"falsecolor", "color pixels by their brightness", FalseColor},
    cli::Command{"info", "size, metadata and range of values", Info},
    cli::Command{"makeequiarea", "latitude-longitude environment to a square equal-area one",
                 MakeEquiArea},
    cli::Command{"merge", "join crops and ranges of samples of one render, exactly", Merge},
    cli::Command{"scalenormalmap", "make the relief of a normal map steeper or flatter",
                 ScaleNormalMap},
    cli::Command{"splitn", "strips of several pictures side by side", SplitN},
    cli::Command{"whitebalance", "make what was white under an illuminant white", WhiteBalanced},
};

}  // namespace

const cli::Tool kTool{"imgtool", "<command> [options] files...", kCommands};

}  // namespace pbrt::imgtool
