#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>

#include "pbrt/base/hit.h"
#include "pbrt/base/plug_in.h"
#include "pbrt/base/surface_interaction.h"
#include "pbrt/scene/description.h"
#include "pbrt/scene/params.h"

namespace pbrt {

struct NamedTextures;

/// Arguments from which every shape is made.
struct ShapeArguments {
    const ShapeEntity &entity;
    ParamDict &params;
    const Transform &renderFromObject;
    const NamedTextures &textures;  ///< that parameters may name
};

/// A point drawn on an emitter. pdf per unit area, or per unit solid angle, as the call says.
struct ShapeSample {
    Point3f p;
    Vector3f pError;  ///< see SurfaceInteraction
    Normal3f n;       ///< unit, on the outside
    Point2f uv;
    float pdf;
};

/// Cone that holds every normal of the primitive: axis and cosine of its half angle.
struct NormalCone {
    Vector3f axis;
    float cosTheta;
};

/// A ray in the space in which a shape intersects itself, in double; 0 <= tMin.
struct RayD {
    Vector3d o, d;
    double tMin, tMax;
};
struct PrimitiveHit {
    double t;
    double u = 0, v = 0;  ///< reach SurfaceAt as Hit::u and v
};

/// Sixteen shapes of one type.
template <typename S>
using ShapePacket = std::array<const S *, kPacketSize>;

/// Abilities that not every shape has. Each shape announces its own by
///   static constexpr ShapeTraits kTraits{.canEmit = true, ...};
/// so that a misspelt trait does not compile, and a trait whose member is missing neither.
struct ShapeTraits {
    /// Can be an area light (EmittingShape). Without it an area light on it is an error.
    bool canEmit = false;
    /// Is intersected by its own code (SelfIntersectingShape), which the ray tracer calls for it.
    /// A shape without it needs code in the ray tracer: accel/native.h.
    bool intersectsItself = false;
    /// Is one primitive with a member `Transform renderFromObject`, and intersects itself in object
    /// space. Without it rays come in rendering space.
    bool hasObjectSpace = false;
    /// Has SurfacesAt (WideShape), which is faster than SurfaceAt in turns from this many rays on.
    /// 0: it has none, and its hits are worked out one by one.
    int fewestWide = 0;
};

/// The contract of shapes. A shape is a plain struct: its data are public, it is copied and moved,
/// and immutable once made. All places and directions are in rendering space (the object's space
/// where it stands in an object that instances repeat), but for what hasObjectSpace says.
///
///   kName, kExamples
///       see PlugInType. The tests place each example in several ways and run every law about
///       shapes on it, so the examples show every branch: whole and partial, flat and bent.
///   static constexpr ShapeTraits kTraits
///   static Made Create(const ShapeArguments &)
///       reads the parameters, each with its default and range. Made is std::optional<S>, or
///       another optional, variant or vector of types in the list of shapes. Empty after an error,
///       which is in the log with its place. Must read every parameter it knows, for the rest are
///       reported as unknown.
///   size_t NPrimitives() const
///       triangles, patches, segments; primitives are numbered from 0.
///   Bounds3f Bounds() const, Bounds3f PrimitiveBounds(uint32_t primitive) const
///       boxes that hold every point of the surface, roundings included.
///   SurfaceInteraction SurfaceAt<kWithError>(const Hit &, const Ray &) const
///       everything about a hit that shading needs, as pbrt-v4 defines (u, v) and tangents; hit.t
///       along the ray. Called once for each vertex of each path. kWithError false: pError is not
///       needed (alpha tests, null transmission).
template <typename S>
concept BasicShape = PlugInType<S> && std::movable<S> &&
    requires(const S s, uint32_t primitive, const Hit &hit, const Ray &ray,
             const ShapeArguments &arguments) {
    { S::kTraits } -> std::same_as<const ShapeTraits &>;
    S::Create(arguments);
    { s.NPrimitives() } -> std::same_as<size_t>;
    { s.Bounds() } -> std::same_as<Bounds3f>;
    { s.PrimitiveBounds(primitive) } -> std::same_as<Bounds3f>;
    { s.template SurfaceAt<true>(hit, ray) } -> std::same_as<SurfaceInteraction>;
    { s.template SurfaceAt<false>(hit, ray) } -> std::same_as<SurfaceInteraction>;
};

/// A shape with canEmit. u in [0, 1)^2; no sample is an error: nullopt where the primitive has no
/// area or is seen edge-on.
///   float Area(primitive) const
///       to 2e-4 of itself.
///   std::optional<ShapeSample> SampleArea(primitive, u) const
///       pdf per unit area: that of the point drawn, exactly. Near uniform by area, for the
///       variance of light is the variance of its inverse.
///   std::optional<ShapeSample> SampleFrom(primitive, ref, u) const
///       pdf per unit solid angle at ref: by solid angle where that is known in closed form, else
///       SeenFrom(SampleArea(primitive, u), ref).
///   float PDFFrom(primitive, ref, p, n) const
///       density of SampleFrom for the direction from ref to p, where the surface has normal n.
///   NormalCone NormalBounds(primitive) const
///       of all normals that SampleArea gives; {axis, -1} where there is no tighter one, which
///       costs noise in scenes of many lights.
template <typename S>
concept EmittingShape = requires(const S s, uint32_t primitive, Point2f u, Point3f ref, Point3f p,
                                 Normal3f n) {
    { s.Area(primitive) } -> std::same_as<float>;
    { s.SampleArea(primitive, u) } -> std::same_as<std::optional<ShapeSample>>;
    { s.SampleFrom(primitive, ref, u) } -> std::same_as<std::optional<ShapeSample>>;
    { s.PDFFrom(primitive, ref, p, n) } -> std::same_as<float>;
    { s.NormalBounds(primitive) } -> std::same_as<NormalCone>;
};

/// A shape with intersectsItself.
///   std::optional<PrimitiveHit> Intersect(primitive, const RayD &) const
///       the smallest t in (tMin, tMax] of a hit. In double, for a float's root is off by 1e-4 of
///       a sphere's radius near grazing. The caller goes on from a hit with tMin = t, so every
///       crossing must be found, each once.
template <typename S>
concept SelfIntersectingShape = requires(const S s, uint32_t primitive, const RayD &ray) {
    { s.Intersect(primitive, ray) } -> std::same_as<std::optional<PrimitiveHit>>;
};

template <typename S>
concept ShapeInObjectSpace = requires(const S s) {
    { s.renderFromObject } -> std::same_as<const Transform &>;
};

/// A shape with fewestWide > 0.
///   bool IsWide<kWithTangents>() const
///       whether SurfacesAt does for this shape.
///   static SurfaceInteractionX16 SurfacesAt<kWithTangents>(const ShapePacket<S> &,
///                                                          const RayHits &, LaneBits active)
///       SurfaceAt of the active lanes, one at least, up to roundings; the others are undefined.
///       Shapes of lanes that are not active repeat one that is. kWithTangents false: dpdu, dpdv,
///       dpdus, uv and faceIndex are not needed.
template <typename S>
concept WideShape = requires(const S s, const ShapePacket<S> &shapes, const RayHits &hits,
                             LaneBits active) {
    { s.template IsWide<true>() } -> std::same_as<bool>;
    { s.template IsWide<false>() } -> std::same_as<bool>;
    { S::template SurfacesAt<true>(shapes, hits, active) } -> std::same_as<SurfaceInteractionX16>;
    { S::template SurfacesAt<false>(shapes, hits, active) } -> std::same_as<SurfaceInteractionX16>;
};

/// The whole contract: BasicShape, what the traits announce, and nothing that they do not.
template <typename S>
concept ShapeType = BasicShape<S> && detail::AsAnnounced<S::kTraits.canEmit, EmittingShape<S>> &&
    detail::AsAnnounced<S::kTraits.intersectsItself, SelfIntersectingShape<S>> &&
    detail::AsAnnounced<S::kTraits.hasObjectSpace, ShapeInObjectSpace<S>> &&
    detail::AsAnnounced<(S::kTraits.fewestWide > 0), WideShape<S>>;

/// ShapeType<S>, or an error that names S and the member that is missing or not announced.
template <BasicShape S>
struct ShapeContract {
    static constexpr bool value = [] {
        if constexpr (S::kTraits.canEmit) static_assert(EmittingShape<S>);
        if constexpr (S::kTraits.intersectsItself) static_assert(SelfIntersectingShape<S>);
        if constexpr (S::kTraits.hasObjectSpace) static_assert(ShapeInObjectSpace<S>);
        if constexpr (S::kTraits.fewestWide > 0) static_assert(WideShape<S>);
        return ShapeType<S>;
    }();
};

}  // namespace pbrt
