#include "pbrt/bsdftool/directions.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "pbrt/util/atomic_file.h"

namespace pbrt::bsdftool {
namespace {

constexpr std::string_view kHeader = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z";

std::string_view Trimmed(std::string_view s) {
    while (!s.empty() && (s.back() == ' ' || s.back() == '\r' || s.back() == '\t'))
        s.remove_suffix(1);
    while (!s.empty() && (s.front() == ' ' || s.front() == '\t')) s.remove_prefix(1);
    return s;
}

std::vector<std::string_view> Split(std::string_view s, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const size_t end = s.find(separator);
        parts.push_back(Trimmed(s.substr(0, end)));
        if (end == std::string_view::npos) return parts;
        s.remove_prefix(end + 1);
    }
}

bool ReadNumber(std::string_view s, double *value) {
    if (!s.empty() && s.front() == '+') s.remove_prefix(1);
    const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), *value);
    return error == std::errc() && end == s.data() + s.size();
}

/// False, with a reason, where v has no direction.
bool Normalise(double *v, std::string_view name, const FileLoc &loc, Diagnostics &log) {
    const double length = std::hypot(v[0], v[1], v[2]);
    if (!std::isfinite(length) || length == 0) {
        log.Error(loc, fmt::format("{} = ({:g}, {:g}, {:g}) is no direction: it must be finite and "
                                   "not 0",
                                   name, v[0], v[1], v[2]));
        return false;
    }
    for (int i = 0; i < 3; ++i) v[i] /= length;
    return true;
}

}  // namespace

std::vector<DirectionPair> ReadDirections(const std::string &fileName, Diagnostics &log) {
    const FileContents file = ReadWholeFile(fileName);
    if (!file.bytes) {
        log.Error({}, file.error);
        return {};
    }
    std::vector<DirectionPair> pairs;
    const std::vector<std::string_view> lines = Split(*file.bytes, '\n');
    if (lines[0] != kHeader) {
        log.Error({fileName, 1, 1}, fmt::format("expected the header \"{}\"", kHeader));
        return {};
    }
    for (size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const FileLoc loc{fileName, int(i) + 1, 1};
        const std::vector<std::string_view> cells = Split(lines[i], ',');
        double v[6] = {};
        bool numbers = cells.size() == 6;
        for (size_t k = 0; k < 6 && numbers; ++k) numbers = ReadNumber(cells[k], &v[k]);
        if (!numbers) {
            log.Error(loc, fmt::format("expected six numbers, found \"{}\"", lines[i]));
            continue;
        }
        if (!Normalise(v, "wo", loc, log) || !Normalise(v + 3, "wi", loc, log)) continue;
        pairs.push_back({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}});
    }
    return pairs;
}

std::vector<float> ReadNumbers(std::string_view text, std::string_view what, float lo, float hi,
                               Diagnostics &log) {
    std::vector<float> numbers;
    for (std::string_view cell : Split(text, ',')) {
        double value = 0;
        if (!ReadNumber(cell, &value))
            log.Error({}, fmt::format("{}: \"{}\" is not a number", what, cell));
        else if (!(value >= lo && value <= hi))
            log.Error({}, fmt::format("{}: {:g} is outside [{:g}, {:g}]", what, value, lo, hi));
        else
            numbers.push_back(float(value));
    }
    return numbers;
}

}  // namespace pbrt::bsdftool
