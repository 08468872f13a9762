#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pbrt/bsdftool/commands.h"
#include "pbrt/bsdftool/material_source.h"
#include "pbrt/spectra/spectrum.h"

namespace pbrt::bsdftool {

/// Options that most commands take, as written.
struct CommonOptions {
    std::string material, pick, illuminant = "equal-energy";
};
/// MATERIAL and --pick.
void AddMaterial(CLI::App *app, CommonOptions *o);
void AddIlluminant(CLI::App *app, CommonOptions *o);

std::optional<MaterialSource> ReadMaterial(const CommonOptions &o, Diagnostics &log);
/// A named spectrum, or the constant 1 for `equal-energy`; an unknown name is an error.
Spectrum ReadIlluminant(const CommonOptions &o, Diagnostics &log);

/// Comma-separated numbers in [lo, hi], at least one; mistakes are errors that name `what`.
std::vector<float> ReadNumbers(std::string_view text, std::string_view what, float lo, float hi,
                               Diagnostics &log);

/// An error where the file could not be written; nothing for an empty name.
void CheckWritable(const std::string &fileName, Diagnostics &log);
void WriteText(const std::string &fileName, std::string_view text, Diagnostics &log);

}  // namespace pbrt::bsdftool
