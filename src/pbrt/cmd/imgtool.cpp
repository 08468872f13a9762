#include "pbrt/imgtool/commands.h"

#include <cstdio>
#include <string>
#include <vector>

int main(int argc, char **argv) {
    const std::vector<std::string> args(argv + 1, argv + argc);
    const pbrt::imgtool::Outcome outcome = pbrt::imgtool::Run(args);
    std::fputs(outcome.out.c_str(), stdout);
    std::fputs(outcome.err.c_str(), stderr);
    return outcome.exitCode;
}
