#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "pbrt/util/transform.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

struct TriangleMesh {
    std::vector<uint32_t> indices;  ///< 3 a triangle
    std::vector<Point3f> p;         ///< rendering space (object's space of an instance)
    std::vector<Normal3f> n;        ///< per vertex, or empty
    std::vector<Vector3f> s;        ///< per vertex tangents, or empty
    std::vector<Point2f> uv;        ///< per vertex, or empty: (0,0) (1,0) (1,1)
    std::vector<int> faceIndices;   ///< per triangle, or empty: the triangle's number
    bool flipNormal = false;        ///< ReverseOrientation xor left-handed transform
    size_t NPrimitives() const { return indices.size() / 3; }
};

/// p(u,v) of corners 00 10 01 11.
struct BilinearMesh {
    std::vector<uint32_t> indices;  ///< 4 a patch
    std::vector<Point3f> p;
    std::vector<Normal3f> n;
    std::vector<Point2f> uv;
    std::vector<int> faceIndices;
    bool flipNormal = false;
    /// Every patch is flat and convex (IsPlanar): traversal takes it as two triangles, and a hit's
    /// (u, v) are linear in each: p00 + u (p10 - p00) + v (p01 - p00) where u + v <= 1, else
    /// p11 + (1 - u) (p01 - p11) + (1 - v) (p10 - p11).
    bool planar = false;
    size_t NPrimitives() const { return indices.size() / 4; }
};

// Quadrics: flipNormal is ReverseOrientation alone. Their normals are transformed as normals, so a
// mirroring transform leaves them on the outside, where triangles' need turning.

struct Sphere {
    Transform renderFromObject;
    float radius = 1, zMin = -1, zMax = 1, phiMax = 2 * Pi;
    bool flipNormal = false;  ///< normals point inwards
    size_t NPrimitives() const { return 1; }
    bool IsFull() const { return zMin <= -radius && zMax >= radius && phiMax >= 2 * Pi; }
};

struct Disk {
    Transform renderFromObject;
    float height = 0, radius = 1, innerRadius = 0, phiMax = 2 * Pi;
    bool flipNormal = false;  ///< normals point along -z
    size_t NPrimitives() const { return 1; }
};

struct Cylinder {
    Transform renderFromObject;
    float radius = 1, zMin = -1, zMax = 1, phiMax = 2 * Pi;
    bool flipNormal = false;  ///< normals point inwards
    size_t NPrimitives() const { return 1; }
};

/// Both turn to the ray; one is shaded as flat, the other as a cylinder. Ribbons are meshes.
enum class CurveType { Flat, Cylinder };

/// A point of a curve's control polygon.
struct CurvePoint {
    Point3f p;
    float radius;  ///< half the width
};

inline constexpr size_t kMaxCurveSegments = size_t(1) << 27;  ///< of one CurveSet

/// Cubic Bezier segments of one type, at most kMaxCurveSegments: 52 bytes each, for neighbours
/// share a point.
struct CurveSet {
    std::vector<uint32_t> first;     ///< per segment: its first point of four
    std::vector<CurvePoint> points;  ///< rendering space (object's space of an instance)
    CurveType type = CurveType::Flat;
    bool flipNormal = false;  ///< ReverseOrientation alone: normals face away from the ray
    bool mirrored = false;    ///< by a left-handed transform: v runs to the other side
    size_t NPrimitives() const { return first.size(); }
};

using Shape = std::variant<TriangleMesh, BilinearMesh, Sphere, Disk, Cylinder, CurveSet>;

}  // namespace pbrt
