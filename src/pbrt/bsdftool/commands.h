#pragma once

#include "pbrt/cli/tool.h"

// What `bsdftool` does, one function per sub-command. Directions are of the material's own local
// frame: z the normal, x along dp/du turned by `rotation`, that is, for feathers, x across and y
// along the barbules. theta is measured from z, phi from x towards y, both in degrees.
namespace pbrt::bsdftool {

using cli::Args;
using cli::Finish;
using cli::Outcome;

extern const cli::Tool kTool;

Outcome RunEval(Args args);
Outcome RunFurnace(Args args);
Outcome RunPlot(Args args);
Outcome RunSpectrum(Args args);

}  // namespace pbrt::bsdftool
