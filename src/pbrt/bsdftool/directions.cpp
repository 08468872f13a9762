#include "pbrt/bsdftool/directions.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "pbrt/bsdftool/csv.h"
#include "pbrt/util/read_file.h"

namespace pbrt::bsdftool {
namespace {

constexpr std::string_view kHeader = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z";

/// nullopt, with a reason in the log, where v has no direction.
std::optional<LocalDirection> Normalized(const double *v, std::string_view name, const FileLoc &loc,
                                         Diagnostics &log) {
    // Scaled first: the length of what is large overflows, and of what is tiny is inexact.
    const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    const bool finite = std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
    if (!finite || largest == 0) {
        log.Error(loc, fmt::format("{} = ({:g}, {:g}, {:g}) is no direction: it must be finite and "
                                   "not 0",
                                   name, v[0], v[1], v[2]));
        return {};
    }
    const double x = v[0] / largest, y = v[1] / largest, z = v[2] / largest;
    const double length = std::hypot(x, y, z);
    return LocalDirection{x / length, y / length, z / length};
}

std::optional<std::array<double, 6>> SixNumbers(std::string_view line) {
    const std::vector<std::string_view> cells = SplitCells(line, ',');
    if (cells.size() != 6) return {};
    std::array<double, 6> values;
    for (size_t k = 0; k < 6; ++k) {
        const std::optional<double> value = ReadNumber(cells[k]);
        if (!value) return {};
        values[k] = *value;
    }
    return values;
}

}  // namespace

std::vector<DirectionPair> ReadDirections(const std::string &fileName, Diagnostics &log) {
    const FileContents file = ReadWholeFile(fileName, Pipes::Taken);
    if (!file.bytes) {
        log.Error({}, file.error);
        return {};
    }
    std::vector<DirectionPair> pairs;
    const std::vector<std::string_view> lines = SplitCells(*file.bytes, '\n');
    if (lines[0] != kHeader) {
        log.Error({fileName, 1, 1}, fmt::format("expected the header \"{}\"", kHeader));
        return {};
    }
    for (size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const FileLoc loc{fileName, int(i) + 1, 1};
        const auto values = SixNumbers(lines[i]);
        if (!values) {
            log.Error(loc, fmt::format("expected six numbers, found \"{}\"", Shortened(lines[i])));
            continue;
        }
        const auto wo = Normalized(values->data(), "wo", loc, log);
        const auto wi = Normalized(values->data() + 3, "wi", loc, log);
        if (wo && wi) pairs.push_back({*wo, *wi});
    }
    return pairs;
}

LocalDirection Spherical(double theta, double phi) {
    const double t = theta * std::numbers::pi / 180, p = phi * std::numbers::pi / 180;
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

}  // namespace pbrt::bsdftool
