#include <vector>

#include "pbrt/feathergen/commands.h"

int main(int argc, char **argv) {
    const std::vector<std::string> args(argv + 1, argv + argc);
    return pbrt::cli::Print(pbrt::feathergen::Run(args));
}
