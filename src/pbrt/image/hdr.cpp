// Radiance HDR (Ward 1991): a text header, then run-length coded RGBE. Small enough to need no
// library. Only the usual orientation, "-Y height +X width".

#include <array>
#include <cmath>
#include <cstdio>

#include "pbrt/image/codecs.h"

namespace pbrt {
namespace {

using Bytes = std::string_view;

std::string_view TakeLine(Bytes *bytes) {
    const size_t end = std::min(bytes->find('\n'), bytes->size());
    const std::string_view line = bytes->substr(0, end);
    bytes->remove_prefix(std::min(end + 1, bytes->size()));
    return line;
}

/// One scan line of four separately coded components; false where it does not fit.
bool TakePackedLine(Bytes *bytes, std::vector<std::array<unsigned char, 4>> *line) {
    for (int component = 0; component < 4; ++component)
        for (size_t x = 0; x < line->size();) {
            if (bytes->size() < 2) return false;
            // Above 128: a run of one value; else that many values of their own.
            const unsigned char code = (*bytes)[0];
            const size_t count = code > 128 ? code - 128 : code;
            const size_t taken = code > 128 ? 1 : count;
            if (count == 0 || count > line->size() - x || bytes->size() < 1 + taken) return false;
            for (size_t i = 0; i < count; ++i)
                (*line)[x++][component] = (*bytes)[1 + (code > 128 ? 0 : i)];
            bytes->remove_prefix(1 + taken);
        }
    return true;
}

bool TakeLine(Bytes *bytes, std::vector<std::array<unsigned char, 4>> *line) {
    const size_t width = line->size();
    const char mark[4] = {2, 2, char(width >> 8), char(width & 255)};
    if (width >= 8 && width < 32768 && bytes->starts_with(Bytes(mark, 4))) {
        bytes->remove_prefix(4);
        return TakePackedLine(bytes, line);
    }
    if (bytes->size() < 4 * width) return false;
    for (auto &pixel : *line) {
        for (int c = 0; c < 4; ++c)
            pixel[c] = (*bytes)[c];
        bytes->remove_prefix(4);
    }
    return true;
}

}  // namespace

OrError<Image> DecodeHdr(Bytes bytes) {
    while (!bytes.empty() && !TakeLine(&bytes).empty())
        continue;
    int width = 0, height = 0;
    const std::string size(TakeLine(&bytes));
    if (std::sscanf(size.c_str(), "-Y %9d +X %9d", &height, &width) != 2)
        return {{}, "is damaged or turned: its size is not \"-Y height +X width\""};
    if (auto reason = Implausible(width, height, 3, 32, 128, bytes.size())) return {{}, *reason};

    Image image({width, height}, {"R", "G", "B"});
    std::vector<std::array<unsigned char, 4>> line(width);
    for (int y = 0; y < height; ++y) {
        if (!TakeLine(&bytes, &line)) return {{}, "is damaged or ends too early"};
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                image.Set({x, y}, c,
                          line[x][3] == 0 ? 0.f : std::ldexp(float(line[x][c]), line[x][3] - 136));
    }
    image.metadata.storedAs = "rgbe";
    return {std::move(image), {}};
}

}  // namespace pbrt
