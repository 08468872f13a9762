// bench_feather: time and error of the feather model.

#include "pbrt/cli/main.h"
#include "bench/feather/command.h"

int main(int argc, char **argv) {
    return pbrt::cli::Main("bench_feather", argc, argv, [](pbrt::cli::Args args) {
        return pbrt::cli::Print(pbrt::bench::Run(args));
    });
}
