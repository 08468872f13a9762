#pragma once

#include <string>

namespace pbrt {

// Absolute folders, as configured. They are functions of one file, so that no other object depends
// on where the clone stands: ccache then serves every clone.

/// The repository.
std::string SourceDir();
/// The built programs.
std::string ProgramDir();

}  // namespace pbrt
