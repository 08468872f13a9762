#pragma once

#include <algorithm>
#include <bit>
#include <cstring>

#include "pbrt/shapes/ply_header.h"

namespace pbrt {

template <typename T>
T LoadValue(const uint8_t *from, bool swap) {
    T value;
    if (!swap) {
        std::memcpy(&value, from, sizeof value);
        return value;
    }
    uint8_t bytes[sizeof(T)];
    for (size_t i = 0; i < sizeof(T); ++i)
        bytes[i] = from[sizeof(T) - 1 - i];
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

inline double LoadValue(const uint8_t *from, PlyType type, bool swap) {
    switch (type) {
        case PlyType::Int8:
            return LoadValue<int8_t>(from, swap);
        case PlyType::UInt8:
            return *from;
        case PlyType::Int16:
            return LoadValue<int16_t>(from, swap);
        case PlyType::UInt16:
            return LoadValue<uint16_t>(from, swap);
        case PlyType::Int32:
            return LoadValue<int32_t>(from, swap);
        case PlyType::UInt32:
            return LoadValue<uint32_t>(from, swap);
        case PlyType::Float32:
            return LoadValue<float>(from, swap);
        default:
            return LoadValue<double>(from, swap);
    }
}

/// Takes one number after the other from the body of a PLY file, whatever its format.
class PlyValues {
  public:
    PlyValues(PlyStream &stream, PlyFormat format)
        : stream(stream),
          format(format),
          isAscii(format == PlyFormat::Ascii),
          swap((format == PlyFormat::BigEndian) != (std::endian::native == std::endian::big)) {}

    /// False at the end of the file and where an ascii word is no such number.
    bool Next(PlyType type, double *value) {
        if (isAscii) return NextWord(type, value);
        const size_t size = PlySize(type);
        if (!stream.Fill(size)) return false;
        *value = LoadValue(stream.Data(), type, swap);
        stream.Skip(size);
        return true;
    }
    bool Skip(PlyType type, uint64_t count);
    /// The property's number, or a list's count with the list passed over.
    bool NextOrSkipList(const PlyProperty &p, double *value) {
        if (!Next(p.countType.value_or(p.type), value)) return false;
        return !p.IsList() || Skip(p.type, *value > 0 ? uint64_t(*value) : 0);
    }

    PlyStream &Stream() { return stream; }
    PlyFormat Format() const { return format; }
    /// Rows of the element to make room for; a gzipped file's promises are not trusted.
    size_t RowsAhead(const PlyElement &e) const {
        return stream.KnowsLength() ? e.count : std::min<size_t>(e.count, size_t(1) << 20);
    }
    /// Description of the mistake, after a call returned false within the element's row.
    std::string ProblemIn(const PlyElement &e, size_t row) const;

    bool Swaps() const { return swap; }

  private:
    bool NextWord(PlyType type, double *value);
    PlyStream &stream;
    PlyFormat format;
    bool isAscii, swap;
    std::string misfit;  ///< the word that is no number
};

}  // namespace pbrt
