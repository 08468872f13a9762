#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pbrt/render/render.h"

namespace CLI {
class App;
}

namespace pbrt::program {

/// First and last frame, both rendered.
struct FrameRange {
    int first = 0, last = 0;
};

/// A file for checkpoints, and how often one is written.
struct CheckpointOption {
    std::string file;  ///< empty: none
    double seconds = 60;
};

/// The command line.
struct Arguments {
    std::vector<std::string> files;
    Overrides overrides;
    Options options;
    std::string statsFile, explain, resume, displayServer;
    CheckpointOption checkpoint;
    std::optional<FrameRange> frames;
    bool stats = false, quiet = false, writePartialImages = false, denoise = false;
    bool format = false, toPly = false, upgrade = false;
    // As written; TakeWritten puts them into `overrides`. Nothing, or 0: not given.
    std::vector<float> crop;
    std::vector<int> bounds, pixel;
    int spp = 0;
};

/// Binds pbrt's options to `arguments`, which must outlive the parsing.
void DefineOptions(CLI::App *app, Arguments *arguments);
/// After the parsing.
void TakeWritten(Arguments *arguments);

}  // namespace pbrt::program
