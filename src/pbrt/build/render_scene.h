#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "pbrt/accel/accel.h"
#include "pbrt/cameras/cameras.h"
#include "pbrt/films/film.h"
#include "pbrt/filters/filters.h"
#include "pbrt/lights/lights.h"
#include "pbrt/materials/material_set.h"
#include "pbrt/materials/mix.h"
#include "pbrt/samplers/samplers.h"

namespace pbrt {

/// Everything a render reads, ready and immutable. Made by BuildScene. Moving a RenderScene keeps
/// its inner pointers valid; it cannot be copied.
struct RenderScene {
    std::vector<Geometry> geometries;
    std::vector<ObjectRange> objects;
    std::vector<Instance> instances;
    MaterialSet materials;
    std::vector<MixMaterial> mixes;  ///< their ids start at kFirstMix
    std::vector<Light> lights;
    std::deque<Shape> emitterShapes;  ///< of lights whose form is not a geometry's
    std::vector<int> infiniteLights;  ///< indices into lights
    std::optional<Accel> accel;

    Camera camera;
    Film film;
    Filter filter;
    Sampler sampler;
    Options options;
    bool filtersTextures = false;  ///< some texture reads the steps per pixel
    bool isAnimated = false;       ///< time matters

    /// Index of the light that a hit on an emissive geometry belongs to.
    static int LightOf(const Geometry &geometry, uint32_t primitive) {
        return geometry.firstLight + (geometry.sharedLight ? 0 : int(primitive));
    }
    /// The hit's surface in rendering space.
    SurfaceInteraction SurfaceAt(const Hit &hit, const Ray &ray) const;
    /// SurfaceAt for the given lanes; the others are undefined. kWithTangents: with derivatives, uv
    /// and faceIndex.
    template <bool kWithTangents>
    SurfaceInteractionX16 SurfaceAt(const HitPacket &hits, const RayPacket &rays,
                                    LaneBits lanes) const;
    /// Point and frames only; see pbrt::SurfaceAtWithoutError.
    SurfaceInteraction SurfaceAtWithoutError(const Hit &hit, const Ray &ray) const;
    /// `clamped`: counts values out of range, unless null.
    TextureEvalContext TextureContext(const SurfaceInteraction &sp,
                                      ClampCounts *clamped = nullptr) const;
    /// TextureContext for the given lanes.
    void TextureContexts(const SurfaceInteractionX16 &sp, LaneBits lanes, ClampCounts *clamped,
                         std::array<TextureEvalContext, kPacketSize> *contexts) const;

    const MixMaterial *AsMix(MaterialId id) const {
        return id >= kFirstMix ? &mixes[id - kFirstMix] : nullptr;
    }
    /// The material that a ray of direction d meets, where `id` is a mix.
    MaterialId MaterialMet(MaterialId id, const SurfaceInteraction &sp, Vector3f d,
                           ClampCounts *clamped = nullptr) const {
        while (const MixMaterial *mix = AsMix(id))
            [[unlikely]] id = mix->Choose(TextureContext(sp, clamped), d, id);
        return id;
    }
    /// Geometries below this stand in the scene as they are; the others only in instances.
    uint32_t TopLevelGeometries() const;
    /// True if light passes straight through; false for materials that could not be made, and for
    /// all where Option "forcediffuse" makes them diffuse.
    bool HasNullTransmission(MaterialId id) const;

  private:
    template <typename T>
    TextureFootprint<T> FootprintAt(const SurfaceInteractionT<T> &sp) const;
};

}  // namespace pbrt
