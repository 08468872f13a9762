#pragma once

#include <string>
#include <vector>

#include "pbrt/feathergen/commands.h"
#include "pbrt/feathergen/feather_files.h"

namespace pbrt::feathergen {

/// Options that both commands have.
struct FeatherOptions {
    std::string preset = "rock-dove-neck", paramsFile, out, textures = "atlas";
    std::vector<std::string> set;
    uint64_t seed = 0;
    bool printPreset = false;

    void AddTo(CLI::App *app);
    /// Applies preset, --params and --set to `parameters`, in this order; what is wrong otherwise.
    std::string Read(Parameters *parameters) const;
    TextureFiles Textures() const;
    /// `out` with a slash at its end.
    std::string Folder() const;
};

}  // namespace pbrt::feathergen
