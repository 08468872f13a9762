#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pbrt/util/result.h"
#include "pbrt/util/vecmath.h"

namespace pbrt::cyhair2pbrt {

/// The strands of a hair file of Cem Yuksel's format, http://www.cemyuksel.com/research/hairmodels:
/// little-endian; a header of 128 bytes ("HAIR", numbers of strands and points, flags, defaults),
/// then segments per strand, points, and, where the flags say so, a thickness for each point.
/// Transparency and color, which may follow, are not read.
struct HairFile {
    std::vector<uint32_t> segments;  ///< of each strand, which has a point more
    std::vector<Point3f> points;     ///< strand after strand
    std::vector<float> thickness;    ///< one a point, or empty
    float defaultThickness = 1;
};

/// The file's contents, or what is wrong with them.
OrError<HairFile> ParseHair(std::string_view bytes);

/// Shapes "curve" of a scene file, a cylinder each: through a strand's points, as Catmull and Rom
/// have it, in cubic Bezier segments; the ends' tangents are those of their segments. y and z
/// change places, for pbrt's scenes have y up.
///   maxStrands  only the first; negative: all
///   width       of all curves; negative: the file's
/// Strands of one point are left out. The text begins with a comment that has numbers and bounds.
std::string CurvesOf(const HairFile &hair, int maxStrands, float width);

}  // namespace pbrt::cyhair2pbrt
