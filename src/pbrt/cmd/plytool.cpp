// plytool: looks at PLY meshes and splits them.

#include "pbrt/cli/main.h"
#include "pbrt/plytool/commands.h"

int main(int argc, char **argv) {
    return pbrt::cli::Main("plytool", argc, argv, [](pbrt::cli::Args args) {
        return pbrt::cli::Print(pbrt::cli::Run(pbrt::plytool::kTool, args));
    });
}
