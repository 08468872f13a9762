#pragma once

#include <map>
#include <span>
#include <string>

#include "pbrt/image/image.h"
#include "pbrt/ptex/texels.h"
#include "pbrt/util/result.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// The faces behind the four edges of a face, -1 none, and which of their edges these are, two bits
/// each.
struct PtexNeighbours {
    std::array<int32_t, 4> faces{-1, -1, -1, -1};
    uint8_t edges = 0;
    bool subface = false;  ///< a quarter of a polygon: its edges are half of a whole face's
    bool uniform = false;  ///< face and neighbours are constant and of one color

    int Edge(int e) const { return edges >> (2 * e) & 3; }
};

/// A Ptex file in memory.
struct PtexData {
    PtexTexels texels;
    int alphaChannel = -1;
    std::vector<PtexNeighbours> neighbours;       ///< per face; empty where no face has any
    std::map<std::string, std::string> metadata;  ///< text entries only
};

/// Reads a whole file: all types and encodings of version 1; no edits. Borders are read as "clamp".
/// Every size is checked against the file's before memory is taken: at most some 1100 times the
/// file's, or 256 MiB where tiles are constant. Where the Ptex library was found it reads the file,
/// else this project's code.
OrError<PtexData> ReadPtex(const std::string &fileName);
/// The like from memory. Precondition: WhatIsWrong(content) is empty.
PtexData PackPtex(const PtexContent &content);

/// Filtered look-ups. Immutable and without locks.
class PtexTexture {
  public:
    explicit PtexTexture(PtexData data);

    PtexMesh Mesh() const { return data.texels.Mesh(); }
    PtexType Type() const { return data.texels.Type(); }
    int NChannels() const { return data.texels.NChannels(); }
    int AlphaChannel() const { return data.alphaChannel; }
    int NFaces() const { return data.texels.NFaces(); }
    /// 1 where the face is constant, else down to one texel.
    int NLevels(int face) const { return data.texels.NLevels(face); }
    /// True where no face has more than one color and none mixes with its neighbours.
    bool IsFlat() const { return flat; }
    const std::map<std::string, std::string> &Metadata() const { return data.metadata; }
    size_t MemoryBytes() const;

    /// The stored texel (x, y) of a level; UInt8 and UInt16 as [0, 1].
    float Texel(int face, int level, Point2i p, int channel) const;

    /// The first out.size() <= NChannels() channels at uv in [0, 1]^2 (of triangles: u + v <= 1,
    /// outside is the nearest such point along u and v) of a face; 0 where the file has no such
    /// face. `width`: how far the filter reaches along u and v, at most 1 is used.
    /// Quads: the mean over a box of that width of the bilinear interpolation of the finest level
    /// at which the box has less than 2 texels on its narrower and 8 on its wider side; bilinear at
    /// width 0. Triangles: a Gaussian of standard deviation width / 2, at least half a texel. Both
    /// cross edges into neighbours, of any resolution; without neighbour quads clamp and triangles
    /// leave out what lies outside; so do edges where whole faces meet subfaces.
    /// At width 0 within 3e-7 of the Ptex library's bilinear filter (test/ptex/read_test.cpp).
    void Lookup(int face, Point2f uv, Vector2f width, std::span<float> out) const;

    const PtexTexels &Texels() const { return data.texels; }
    const PtexNeighbours *Neighbours(int face) const {
        return data.neighbours.empty() ? nullptr : &data.neighbours[size_t(face)];
    }
    /// Content as WritePtex takes it; subfaces have lost what made them such.
    PtexContent Content() const;

  private:
    PtexData data;
    bool flat;
};

}  // namespace pbrt
