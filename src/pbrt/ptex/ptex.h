#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pbrt {

enum class PtexMesh : uint32_t { Triangle, Quad };
enum class PtexType : uint32_t { UInt8, UInt16, Half, Float };

/// A face's resolution is (2^log2U, 2^log2V) texels. Edges of quads: 0 v = 0, 1 u = 1, 2 v = 1,
/// 3 u = 0; of triangles: 0 v = 0, 1 u + v = 1, 2 u = 0. `neighbours`: the face behind each edge,
/// -1 none; `neighbourEdges`: which of that face's edges it is. Both are optional for writing.
struct PtexFace {
    int log2U = 0, log2V = 0;
    std::array<int, 4> neighbours{-1, -1, -1, -1};
    std::array<int, 4> neighbourEdges{};

    size_t NTexels() const { return size_t(1) << (log2U + log2V); }
};

/// Content of a Ptex file, without reductions. Texels lie face after face, in a face row after row
/// by rising v, in a row by rising u, channels interleaved; those of UInt8 and UInt16 are in
/// [0, 1]. In triangles (log2U = log2V) texel (x, y) with x + y below the resolution n is a small
/// triangle of the face's orientation, else the inverted one of cell (n - 1 - y, n - 1 - x).
struct PtexContent {
    PtexMesh mesh = PtexMesh::Quad;
    PtexType type = PtexType::Float;
    int nChannels = 1;
    int alphaChannel = -1;  ///< -1: none
    std::vector<PtexFace> faces;
    std::vector<float> texels;
    std::map<std::string, std::string> metadata;
};

/// One texel a face, no neighbours: `values` holds nChannels per face.
PtexContent ConstantPtex(int nChannels, std::vector<float> values);

constexpr int kPtexMaxLog2 = 15;        ///< of a face's resolution
constexpr int kPtexMaxChannels = 1024;  ///< in a file

/// Replaces the file as a whole or not at all (WriteFileAtomically). Reductions are made here (not
/// where there is alpha): box means down to four texels across. UInt8 and UInt16 are clamped to [0,
/// 1] and rounded, Half is clamped to +-65504. The reason, a sentence with the file's name, where
/// it cannot be written or the content contradicts itself or has a texel that is not finite.
std::optional<std::string> WritePtex(const std::string &fileName, const PtexContent &content);

}  // namespace pbrt
