#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pbrt/util/diagnostics.h"

namespace pbrt::bsdftool {

/// Unit directions in the local frame, in double so that the oracle can use them.
struct DirectionPair {
    double wo[3], wi[3];
};

/// Lines of `wo_x,wo_y,wo_z,wi_x,wi_y,wi_z` after exactly that header; directions are normalised.
/// A line that is not six numbers, or a direction that is not finite or 0, is an error at its line.
std::vector<DirectionPair> ReadDirections(const std::string &fileName, Diagnostics &log);

/// Comma-separated numbers in [lo, hi], at least one; mistakes are errors that name `what`.
std::vector<float> ReadNumbers(std::string_view text, std::string_view what, float lo, float hi,
                               Diagnostics &log);

}  // namespace pbrt::bsdftool
