#include <vector>

#include "pbrt/imgtool/commands.h"

int main(int argc, char **argv) {
    const std::vector<std::string> args(argv + 1, argv + argc);
    return pbrt::cli::Print(pbrt::cli::Run(pbrt::imgtool::kTool, args));
}
