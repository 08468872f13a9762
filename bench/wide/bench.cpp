// Nanoseconds for each lane of what is computed sixteen at a time, beside the same one by one.
// Writes CSV: what, ns.
//   bench_wide [rounds, default 20]

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "bench/wide/samplers.h"
#include "bench/wide/surfaces.h"

int main(int argc, char **argv) {
    pbrt::bench::Stopwatch watch;
    pbrt::bench::AddSamplers(watch);
    pbrt::bench::AddSurfaces(watch);
    watch.Run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 20);
    for (const auto &[name, ns] : watch.All())
        std::printf("%s,%.2f\n", name.c_str(), ns);
}
