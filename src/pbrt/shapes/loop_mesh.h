#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// A triangle mesh that Loop's scheme subdivides (Loop 1987), with Warren's weights as in pbrt-v4:
/// of valence n 3 / (8 n) for each neighbour, 3/16 where n = 3. Boundaries become cubic B-splines.
///
/// Any triangles serve: edges that three share, or two that run the same way along it, are cut
/// open; a point where the mesh only touches itself becomes several.
class LoopMesh {
  public:
    /// `indices`: three different points a triangle.
    LoopMesh(const std::vector<Point3f> &points, const std::vector<uint32_t> &indices);
    /// The mesh with each triangle cut in four, which has the same limit.
    LoopMesh Subdivided() const;

    const std::vector<uint32_t> &Indices() const { return corners; }
    size_t NVertices() const { return positions.size(); }
    Point3f Position(uint32_t vertex) const { return ToFloat(positions[vertex]); }
    /// Place of the vertex in the limit of subdivisions.
    Point3f LimitPosition(uint32_t vertex) const;
    /// The limit's normal there, unit or 0, on the side from which triangles run anticlockwise
    /// (right-handed); 0 where the surface is degenerate.
    Normal3f LimitNormal(uint32_t vertex) const;

    /// Bytes of a mesh of so many triangles, and of what it is subdivided from.
    static double BytesOf(double triangles) { return triangles * 60; }

  private:
    // A triangle's half-edge h runs from corners[h] to the next corner of the same triangle.
    static constexpr uint32_t kNone = ~uint32_t(0);
    static uint32_t Next(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static uint32_t Previous(uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    static Point3f ToFloat(Vector3d v) { return {float(v.x), float(v.y), float(v.z)}; }

    /// Neighbours of a vertex, anticlockwise; at a boundary from its one end to the other.
    struct Ring {
        std::vector<Vector3d> p;
        bool isClosed;
    };

    LoopMesh() = default;
    void FindTwins();
    void SplitVertices(const std::vector<Point3f> &points);
    Ring RingOf(uint32_t vertex) const;
    Vector3d Smoothed(uint32_t vertex) const;
    Vector3d EdgePoint(uint32_t h) const;

    std::vector<Vector3d> positions;
    std::vector<uint32_t> corners;
    std::vector<uint32_t> twins;  ///< the half-edge that runs the other way; kNone at boundaries
    std::vector<uint32_t>
        first;  ///< of each vertex a half-edge from it: at a boundary the one on it
};

}  // namespace pbrt
