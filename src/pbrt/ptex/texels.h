#pragma once

#include <half.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "pbrt/ptex/ptex.h"
#include "pbrt/util/check.h"

namespace pbrt {

constexpr size_t PtexTypeSize(PtexType type) {
    return type == PtexType::UInt8 ? 1 : type == PtexType::Float ? 4 : 2;
}

/// Calls f with a value of the C++ type that holds what `type` stores.
template <typename F>
decltype(auto) WithPtexType(PtexType type, F f) {
    switch (type) {
        case PtexType::UInt8:
            return f(uint8_t());
        case PtexType::UInt16:
            return f(uint16_t());
        case PtexType::Half:
            return f(Imath::half());
        default:
            return f(float());
    }
}

/// Factor from a stored value to the value it stands for: integers to [0, 1].
template <typename T>
constexpr float PtexScale() {
    if constexpr (std::is_integral_v<T>) return 1.f / std::numeric_limits<T>::max();
    return 1;
}

/// The texels of all faces as the file stores them, interleaved, each face with its reductions:
/// level l has half the texels of level l - 1 along each side that has more than one; the last has
/// one. Constant faces have one texel and one level.
class PtexTexels {
  public:
    PtexTexels() = default;
    PtexTexels(PtexMesh mesh, PtexType type, int nChannels)
        : mesh(mesh), type(type), nChannels(nChannels) {}

    /// Faces are added first, with exponents in [0, kPtexMaxLog2]; then memory is taken at once.
    void ReserveFaces(size_t n) { faces.reserve(n); }
    void AddFace(int log2U, int log2V, bool constant);
    uint64_t BytesNeeded() const { return nTexels * PixelSize(); }
    void Allocate() { bytes.resize(BytesNeeded()); }
    /// Fills a level above 0 with the means of the one below.
    void Reduce(int face, int level);

    PtexMesh Mesh() const { return mesh; }
    PtexType Type() const { return type; }
    int NChannels() const { return nChannels; }
    size_t PixelSize() const { return PtexTypeSize(type) * size_t(nChannels); }
    int NFaces() const { return int(faces.size()); }
    bool IsConstant(int face) const { return faces[size_t(face)].constant; }
    int Log2U(int face) const { return faces[size_t(face)].log2U; }
    int Log2V(int face) const { return faces[size_t(face)].log2V; }
    int NLevels(int face) const {
        return IsConstant(face) ? 1 : 1 + std::max(Log2U(face), Log2V(face));
    }
    /// Bytes of one level; texels along u: 2^(Log2U - level) but at least 1, along v the like.
    size_t LevelBytes(int face, int level) const {
        return (size_t(1) << (std::max(Log2U(face) - level, 0) +
                              std::max(Log2V(face) - level, 0))) *
               PixelSize();
    }
    std::byte *Level(int face, int level) {
        return bytes.data() + (faces[size_t(face)].begin + LevelBegin(face, level)) * PixelSize();
    }
    const std::byte *Level(int face, int level) const {
        return const_cast<PtexTexels *>(this)->Level(face, level);
    }
    /// T: WithPtexType's.
    template <typename T>
    const T *LevelAs(int face, int level) const {
        DCHECK(sizeof(T) == PtexTypeSize(type));
        return reinterpret_cast<const T *>(Level(face, level));
    }
    size_t MemoryBytes() const { return bytes.capacity() + faces.capacity() * sizeof(Face); }

  private:
    struct Face {
        uint64_t begin;  ///< in texels
        int8_t log2U, log2V;
        bool constant;
    };

    /// Texels of the levels below, in closed form: a geometric series of 4 while both sides shrink,
    /// then of 2.
    size_t LevelBegin(int face, int level) const {
        const int u = Log2U(face), v = Log2V(face), both = std::min(std::min(u, v), level);
        size_t n = ((size_t(4) << (u + v)) - (size_t(4) << (u + v - 2 * both))) / 3;
        if (level > both) {
            const int rest = std::max(u, v) - both;
            n += (size_t(2) << rest) - ((size_t(2) << rest) >> (level - both));
        }
        return n;
    }

    PtexMesh mesh = PtexMesh::Quad;
    PtexType type = PtexType::Float;
    int nChannels = 1;
    uint64_t nTexels = 0;
    std::vector<Face> faces;
    std::vector<std::byte> bytes;
};

}  // namespace pbrt
