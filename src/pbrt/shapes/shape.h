#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "pbrt/scene/description.h"
#include "pbrt/textures/texture.h"
#include "pbrt/util/transform.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// What traversal returns: compact, no derivatives. u, v are barycentrics of the second and third
/// vertex for triangles, the patch's (u, v) for bilinear patches, (u, v) in [0, 1]^2 else.
struct Hit {
    float t;
    float u, v;
    uint32_t geometry;       ///< index into World::geometries
    uint32_t primitive;      ///< triangle, patch... within it
    uint32_t instance = ~0u;  ///< index into World::instances; ~0u: none
};

/// A point on a surface, all in rendering space. n and ns are unit and n points to the outside as
/// ReverseOrientation and handedness say; ns lies in n's hemisphere.
struct SurfacePoint {
    Point3f p;
    Vector3f pError;  ///< conservative absolute error of p per axis
    Normal3f n, ns;
    Vector3f dpdu, dpdv;  ///< of the true surface
    Vector3f dpdus;       ///< shading tangent: the BSDF frame's x (S where given)
    Point2f uv;
    int faceIndex = 0;

    Frame ShadingFrame() const { return Frame::FromZTangent(ns, dpdus); }
    /// Origin for a ray that leaves into direction w without meeting this surface again.
    Point3f OffsetOrigin(Vector3f w) const {
        const float d = Dot(Abs(n), pError);
        return p + n * (Dot(w, n) < 0 ? -d : d);
    }
};

/// A point drawn on an emitter. pdf per unit area, or per unit solid angle, as the call says.
struct ShapeSample {
    Point3f p;
    Vector3f pError;
    Normal3f n;
    Point2f uv;
    float pdf;
};

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
    size_t NPrimitives() const { return indices.size() / 4; }
};

struct Sphere {
    Transform renderFromObject;
    float radius = 1, zMin = -1, zMax = 1, phiMax = 2 * Pi;
    bool flipNormal = false;
    size_t NPrimitives() const { return 1; }
};

struct Disk {
    Transform renderFromObject;
    float height = 0, radius = 1, innerRadius = 0, phiMax = 2 * Pi;
    bool flipNormal = false;
    size_t NPrimitives() const { return 1; }
};

struct Cylinder {
    Transform renderFromObject;
    float radius = 1, zMin = -1, zMax = 1, phiMax = 2 * Pi;
    bool flipNormal = false;
    size_t NPrimitives() const { return 1; }
};

using Shape = std::variant<TriangleMesh, BilinearMesh, Sphere, Disk, Cylinder>;

/// Makes the shapes one directive describes: usually one; a PLY file with triangles and quads makes
/// two. Empty after an error (which is in the log).
std::vector<Shape> CreateShapes(const ShapeEntity &entity, ParamDict &params,
                                const Transform &renderFromObject);
std::span<const std::string_view> ShapeNames();

size_t NPrimitives(const Shape &shape);
Bounds3f Bounds(const Shape &shape);
/// Everything about a hit that shading needs. `hit.t` along `ray`; for instances the ray and the
/// result are in the instance's object space.
SurfacePoint Interact(const Shape &shape, const Hit &hit, const Ray &ray);
/// Only n (unit, oriented) and uv of a hit: what alpha tests and gap transmittance need is less
/// than Interact's work. dpdus and ns included; pError not.
SurfacePoint InteractLightly(const Shape &shape, const Hit &hit, const Ray &ray);

float Area(const Shape &shape, uint32_t primitive);
/// Uniform by area; pdf per unit area.
std::optional<ShapeSample> SampleArea(const Shape &shape, uint32_t primitive, Point2f u);
/// As seen from `ref`: pdf per unit solid angle. Spheres by their cone, triangles by their
/// spherical triangle where it is neither tiny nor huge, else by area.
std::optional<ShapeSample> SampleFrom(const Shape &shape, uint32_t primitive, Point3f ref,
                                      Point2f u);
/// Density of SampleFrom for the direction wi from ref, which is known to meet the primitive at
/// `p` with normal n.
float PDFFrom(const Shape &shape, uint32_t primitive, Point3f ref, Vector3f wi, Point3f p,
              Normal3f n);
/// Cone that holds every normal of the primitive: axis and cosine of its half angle.
struct NormalCone {
    Vector3f axis;
    float cosTheta;
};
NormalCone NormalBounds(const Shape &shape, uint32_t primitive);

}  // namespace pbrt
