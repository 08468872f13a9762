#include "pbrt/cyhair2pbrt/hair_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace pbrt::cyhair2pbrt {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr size_t kHeader = 128;
enum Flags : uint32_t { HasSegments = 1, HasPoints = 2, HasThickness = 4 };

template <typename T>
T At(std::string_view bytes, size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

/// Takes `count` numbers off the front; false where there are fewer.
template <typename T>
bool Take(std::string_view *bytes, size_t count, std::vector<T> *values) {
    if (bytes->size() / sizeof(T) < count) return false;
    values->resize(count);
    if (count > 0) std::memcpy(values->data(), bytes->data(), count * sizeof(T));
    bytes->remove_prefix(count * sizeof(T));
    return true;
}

Point3f UpIsY(Point3f p) {
    return {p.x, p.z, p.y};
}

std::string PointText(Point3f p) {
    return fmt::format(" {} {} {}", p.x, p.y, p.z);
}

/// Bezier points through p[0] ... p[n]: 3 n + 1.
std::string BezierText(const Point3f *p, size_t n) {
    const auto tangent = [&](size_t i) {
        const Vector3f d = p[std::min(i + 1, n)] - p[i == 0 ? 0 : i - 1];
        return i == 0 || i == n ? d : d * 0.5f;
    };
    std::string text = PointText(UpIsY(p[0]));
    for (size_t i = 0; i < n; ++i)
        text += PointText(UpIsY(p[i] + tangent(i) * (1 / 3.f))) +
                PointText(UpIsY(p[i + 1] - tangent(i + 1) * (1 / 3.f))) +
                PointText(UpIsY(p[i + 1]));
    return text;
}

}  // namespace

OrError<HairFile> ParseHair(std::string_view bytes) {
    if (bytes.size() < kHeader || !bytes.starts_with("HAIR"))
        return {{}, "is no hair file: it does not start with \"HAIR\" and a header of 128 bytes"};
    const auto strands = At<uint32_t>(bytes, 4), points = At<uint32_t>(bytes, 8),
               flags = At<uint32_t>(bytes, 12), defaultSegments = At<uint32_t>(bytes, 16);
    HairFile hair;
    hair.defaultThickness = At<float>(bytes, 20);
    if (!(flags & HasPoints)) return {{}, "has no points"};
    bytes.remove_prefix(kHeader);
    constexpr char kShort[] = "ends before all its strands are there";
    if (flags & HasSegments) {
        std::vector<uint16_t> given;
        if (!Take(&bytes, strands, &given)) return {{}, kShort};
        hair.segments.assign(given.begin(), given.end());
    } else {
        if (strands > points)
            return {{}, fmt::format("has {} points for {} strands", points, strands)};
        hair.segments.assign(strands, defaultSegments);
    }
    uint64_t needed = 0;
    for (const uint32_t n : hair.segments)
        needed += uint64_t(n) + 1;
    if (needed != points)
        return {{}, fmt::format("has {} points, where its strands need {}", points, needed)};
    if (!Take(&bytes, points, &hair.points)) return {{}, kShort};
    if ((flags & HasThickness) && !Take(&bytes, points, &hair.thickness)) return {{}, kShort};
    for (const Point3f &p : hair.points)
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            return {{}, "has a point that is not finite"};
    return {std::move(hair), {}};
}

std::string CurvesOf(const HairFile &hair, int maxStrands, float width) {
    std::string curves;
    size_t at = 0, written = 0;
    Point3f low{Infinity, Infinity, Infinity}, high{-Infinity, -Infinity, -Infinity};
    for (const uint32_t n : hair.segments) {
        const Point3f *const p = &hair.points[at];
        const auto widthAt = [&](size_t i) {
            if (width >= 0) return width;
            return hair.thickness.empty() ? hair.defaultThickness : hair.thickness[at + i];
        };
        if (n > 0 && (maxStrands < 0 || written < size_t(maxStrands))) {
            curves += fmt::format(
                "Shape \"curve\" \"string type\" \"cylinder\" \"point3 P\" [{} ] "
                "\"float width0\" {} \"float width1\" {}\n",
                BezierText(p, n), widthAt(0), widthAt(n));
            ++written;
            for (size_t i = 0; i <= n; ++i)
                for (int c = 0; c < 3; ++c) {
                    low[c] = std::min(low[c], UpIsY(p[i])[c]);
                    high[c] = std::max(high[c], UpIsY(p[i])[c]);
                }
        }
        at += n + 1;
    }
    const std::string bounds = written == 0
                                   ? ""
                                   : fmt::format(" within ({}, {}, {}) and ({}, {}, {})", low.x,
                                                 low.y, low.z, high.x, high.y, high.z);
    return fmt::format("# {} of {} strands{}\n", written, hair.segments.size(), bounds) + curves;
}

}  // namespace pbrt::cyhair2pbrt
