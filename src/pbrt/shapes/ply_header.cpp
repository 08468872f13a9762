#include "pbrt/shapes/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "pbrt/util/parse_number.h"

namespace pbrt {

int PlyElement::Find(std::string_view wanted) const {
    for (size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == wanted) return int(i);
    return -1;
}

size_t PlyElement::LeastRowBytes(PlyFormat format) const {
    size_t bytes = 0;
    for (const PlyProperty &p : properties)
        bytes += format == PlyFormat::Ascii ? 2 : PlySize(p.countType.value_or(p.type));
    return bytes;
}

namespace {

std::vector<std::string_view> Words(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::string_view kSpace = " \t\r";
    for (size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;) {
        const size_t end = std::min(line.find_first_of(kSpace, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(kSpace, end);
    }
    return words;
}

std::optional<PlyType> TypeNamed(std::string_view name) {
    struct Row {
        std::string_view old, sized;
    };
    constexpr Row kNames[] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                              {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                              {"float", "float32"}, {"double", "float64"}};
    for (size_t i = 0; i < std::size(kNames); ++i)
        if (kNames[i].old == name || kNames[i].sized == name) return PlyType(i);
    return {};
}

/// Reads header lines one by one; each handler says whether to go on.
class HeaderReader {
  public:
    HeaderReader(PlyStream &stream, std::string *problem) : stream(stream), problem(problem) {}

    std::optional<PlyHeader> Read() {
        const auto magic = Line();
        if (!magic || *magic != "ply")
            return Fail("is no PLY file: it does not start with \"ply\"");
        bool hasFormat = false;
        for (;;) {
            const auto line = Line();
            if (!line) return Fail("ends before \"end_header\"");
            const std::vector<std::string_view> words = Words(*line);
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "end_header") break;
            bool good;
            if (words[0] == "format")
                good = hasFormat = Format(words);
            else if (words[0] == "element")
                good = Element(words);
            else if (words[0] == "property")
                good = Property(words);
            else
                good = false;
            if (!good)
                return Fail(
                    fmt::format("header line {} is not understood: \"{:.60}\"", number, *line));
        }
        if (!hasFormat) return Fail("its header has no \"format\" line");
        return header;
    }

  private:
    std::optional<std::string> Line() {
        constexpr size_t kLongest = 4096;
        stream.Fill(kLongest);
        const size_t length = std::min(stream.Available(), kLongest);
        const void *const found = length ? std::memchr(stream.Data(), '\n', length) : nullptr;
        if (!found) return {};
        const size_t n = size_t(static_cast<const uint8_t *>(found) - stream.Data());
        std::string line(reinterpret_cast<const char *>(stream.Data()), n);
        if (!line.empty() && line.back() == '\r') line.pop_back();
        stream.Skip(n + 1);
        ++number;
        return line;
    }

    bool Format(const std::vector<std::string_view> &words) {
        constexpr std::string_view kNames[] = {"ascii", "binary_little_endian",
                                               "binary_big_endian"};
        if (words.size() != 3 || words[2] != "1.0") return false;
        const auto *const name = std::find(std::begin(kNames), std::end(kNames), words[1]);
        header.format = PlyFormat(name - kNames);
        return name != std::end(kNames);
    }

    bool Element(const std::vector<std::string_view> &words) {
        if (words.size() != 3) return false;
        for (const PlyElement &e : header.elements)
            if (e.name == words[1]) return false;
        PlyElement element;
        element.name = words[1];
        const auto count = ParseWhole<decltype(element.count)>(words[2]);
        if (!count) return false;
        element.count = *count;
        header.elements.push_back(std::move(element));
        return true;
    }

    bool Property(const std::vector<std::string_view> &words) {
        if (header.elements.empty()) return false;
        const bool isList = words.size() == 5 && words[1] == "list";
        if (!isList && words.size() != 3) return false;
        const auto type = TypeNamed(words[isList ? 3 : 1]);
        const auto countType = isList ? TypeNamed(words[2]) : std::nullopt;
        PlyElement &element = header.elements.back();
        if (!type || element.Find(words.back()) >= 0) return false;
        if (isList && (!countType || !IsIntegral(*countType))) return false;
        element.properties.push_back({std::string(words.back()), *type, countType});
        return true;
    }

    std::nullopt_t Fail(std::string message) {
        *problem = stream.Problem().empty() ? std::move(message) : stream.Problem();
        return std::nullopt;
    }

    PlyStream &stream;
    std::string *problem;
    PlyHeader header;
    int number = 0;
};

}  // namespace

std::optional<PlyHeader> ReadPlyHeader(PlyStream &stream, std::string *problem) {
    return HeaderReader(stream, problem).Read();
}

}  // namespace pbrt
