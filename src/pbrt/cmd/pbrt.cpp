// pbrt: renders scene files.

#include "pbrt/cli/main.h"
#include "pbrt/pbrt/run.h"

int main(int argc, char **argv) {
    return pbrt::cli::Main("pbrt", argc, argv, [](pbrt::cli::Args words) {
        return pbrt::cli::Print(pbrt::cli::RunWithOptions(
            words, "pbrt", "pbrt-feather: a spectral path tracer for iridescent feathers",
            pbrt::program::DefineOptions, pbrt::program::Run));
    });
}
