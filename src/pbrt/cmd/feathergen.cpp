#include <vector>

#include "pbrt/feathergen/commands.h"

#include "pbrt/cli/main.h"
#include "pbrt/cli/threads.h"

int main(int argc, char **argv) {
    return pbrt::cli::Main("feathergen", argc, argv, [](pbrt::cli::Args args) {
        pbrt::cli::LimitThreads(0);
        return pbrt::cli::Print(pbrt::feathergen::Run(args));
    });
}
