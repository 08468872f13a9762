#include "pbrt/bsdftool/commands.h"

int main(int argc, char **argv) {
    return pbrt::cli::Print(pbrt::bsdftool::Run(std::vector<std::string>(argv + 1, argv + argc)));
}
