#include "pbrt/plytool/commands.h"

#include <array>

namespace pbrt::plytool {
namespace {

constexpr std::array kCommands{
    cli::Command{"cat", "print meshes as shapes of a scene file", Cat},
    cli::Command{"info", "vertices, faces and bounds", Info},
    cli::Command{"split", "cut a mesh into files of fewer faces", Split},
};

}  // namespace

const cli::Tool kTool{"plytool", "<command> [options] files...", kCommands};

}  // namespace pbrt::plytool
