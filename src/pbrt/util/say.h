#pragma once

#include <cstdio>
#include <string_view>

namespace pbrt {

/// Writes to standard error. What cannot be written there (a full disk, a terminal that is gone) is
/// lost, and nothing else: fmt::print would throw.
inline void Say(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace pbrt
