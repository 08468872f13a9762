#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pbrt/util/vecmath.h"

// Packets of the protocol by which the image viewer tev (https://github.com/Tom94/tev) is told of
// pictures, as its source and pbrt-v4's describe it: 4 bytes with the packet's length, these
// included, a byte with its kind, then its fields; whole numbers and floats of 32 bits, the lowest
// byte first; texts end with a byte 0.
namespace pbrt::program::tev {

enum class Kind : unsigned char { UpdateImage = 3, CreateImage = 4 };

inline constexpr int kPort = 14158;

/// A picture of this name and size, or in the place of one of this name.
std::string CreateImage(std::string_view name, Point2i size,
                        std::span<const std::string_view> channels);
/// Values of one channel in a rectangle, row by row.
std::string UpdateImage(std::string_view name, std::string_view channel, Point2i corner,
                        Point2i size, std::span<const float> values);

}  // namespace pbrt::program::tev
