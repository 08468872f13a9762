#include "pbrt/shapes/ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace pbrt {
namespace {

constexpr bool IsSpace(uint8_t c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

bool PlyValues::NextWord(PlyType type, double *value) {
    constexpr size_t kLongest = 512;
    for (;;) {
        stream.Fill(kLongest);
        if (stream.Available() == 0) return false;
        size_t n = 0;
        while (n < stream.Available() && IsSpace(stream.Data()[n]))
            ++n;
        stream.Skip(n);
        if (stream.Available() > 0) break;
    }
    stream.Fill(kLongest);
    const char *first = reinterpret_cast<const char *>(stream.Data());
    const char *const last = first + std::min(stream.Available(), kLongest);
    const char *const start = first;
    if (*first == '+') ++first;
    std::from_chars_result parsed{};
    if (IsIntegral(type)) {
        int64_t integer = 0;
        parsed = std::from_chars(first, last, integer);
        *value = double(integer);
    } else {
        parsed = std::from_chars(first, last, *value);
        if (parsed.ec == std::errc::result_out_of_range) {  // for double
            long double wide = 0;
            parsed = std::from_chars(first, last, wide);
            *value = double(wide);
        }
    }
    if (parsed.ec != std::errc() || (parsed.ptr != last && !IsSpace(uint8_t(*parsed.ptr)))) {
        const char *end = start;
        while (end != last && end - start < 30 && !IsSpace(uint8_t(*end)))
            ++end;
        misfit.assign(start, end);
        return false;
    }
    stream.Skip(size_t(parsed.ptr - start));
    return true;
}

bool PlyValues::Skip(PlyType type, uint64_t count) {
    if (isAscii) {
        double value;
        while (count-- > 0)
            if (!NextWord(type, &value)) return false;
        return true;
    }
    for (uint64_t bytes = count * PlySize(type); bytes > 0;) {
        if (!stream.Fill(1)) return false;
        const size_t n = size_t(std::min<uint64_t>(bytes, stream.Available()));
        stream.Skip(n);
        bytes -= n;
    }
    return true;
}

std::string PlyValues::ProblemIn(const PlyElement &e, size_t row) const {
    if (!stream.Problem().empty()) return stream.Problem();
    if (!misfit.empty()) return fmt::format("\"{}\" in {} {} is no number", misfit, e.name, row);
    return fmt::format("ends in {} {} of {}", e.name, row, e.count);
}

}  // namespace pbrt
