#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/shapes/ply_stream.h"

namespace pbrt {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType : uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

constexpr size_t PlySize(PlyType type) {
    constexpr uint8_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[int(type)];
}
constexpr bool IsIntegral(PlyType type) {
    return type < PlyType::Float32;
}

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> countType;  ///< of lists
    bool IsList() const { return countType.has_value(); }
};

struct PlyElement {
    std::string name;
    uint32_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of a property, or -1.
    int Find(std::string_view name) const;
    /// Bytes of a row with empty lists; in ascii each number takes two.
    size_t LeastRowBytes(PlyFormat format) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
};

/// Reads up to and with `end_header`; after an error nullopt, `problem` says what is wrong.
std::optional<PlyHeader> ReadPlyHeader(PlyStream &stream, std::string *problem);

}  // namespace pbrt
