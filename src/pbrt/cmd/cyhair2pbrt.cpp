// cyhair2pbrt: turns hair files into curves of a scene file.

#include "pbrt/cli/main.h"
#include "pbrt/cyhair2pbrt/command.h"

int main(int argc, char **argv) {
    return pbrt::cli::Main("cyhair2pbrt", argc, argv, [](pbrt::cli::Args args) {
        return pbrt::cli::Print(pbrt::cyhair2pbrt::Run(args));
    });
}
