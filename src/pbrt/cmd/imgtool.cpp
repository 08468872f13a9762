#include <vector>

#include "pbrt/imgtool/commands.h"

#include "pbrt/cli/main.h"
#include "pbrt/cli/threads.h"

int main(int argc, char **argv) {
    return pbrt::cli::Main("imgtool", argc, argv, [](pbrt::cli::Args args) {
        pbrt::cli::LimitThreads(0);
        return pbrt::cli::Print(pbrt::cli::Run(pbrt::imgtool::kTool, args));
    });
}
