#pragma once

#include <string>
#include <string_view>

#include "pbrt/util/diagnostics.h"

namespace pbrt::program {

inline constexpr int kSuccess = 0, kUserError = 1;

/// "Error: why" on standard error; the exit code.
int Complain(std::string_view why);
void Warn(std::string_view what);
/// On standard output; the exit code.
int PrintOut(std::string_view text);
/// The first messages by place; a broken file can make thousands. Where not all are shown and there
/// are errors, or `quiet`, warnings are left out.
void Print(const Diagnostics &log, bool quiet);

/// "0.34 s", "13 s", "12 min 5 s", "3 h 12 min".
std::string DurationText(double seconds);

}  // namespace pbrt::program
