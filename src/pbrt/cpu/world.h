#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "pbrt/accel/accel.h"
#include "pbrt/cameras/camera.h"
#include "pbrt/films/film.h"
#include "pbrt/filters/filters.h"
#include "pbrt/lights/light_sampler.h"
#include "pbrt/lights/lights.h"
#include "pbrt/materials/material.h"
#include "pbrt/materials/mix.h"
#include "pbrt/samplers/samplers.h"

namespace pbrt {

/// Which of the two ways to find light a path uses. Both together is what renders; one alone is for
/// tests and measurements: all three have the same mean (but for lights that one cannot find).
enum class LightStrategy { Both, LightsOnly, BSDFOnly };

struct PathSettings {
    int maxDepth = 5;
    bool regularize = false;
    LightStrategy strategy = LightStrategy::Both;
};

/// Everything a render reads, ready and immutable. Made by BuildWorld. Moving a World keeps its
/// inner pointers valid; it cannot be copied.
struct World {
    std::vector<Geometry> geometries;
    std::vector<ObjectRange> objects;
    std::vector<Instance> instances;
    std::vector<Material> materials;
    std::vector<MixMaterial> mixes;  ///< their ids start at kFirstMix
    std::vector<Light> lights;
    std::deque<Shape> emitterShapes;  ///< of lights whose form is not a geometry's
    std::vector<int> infiniteLights;  ///< indices into lights
    LightSampler lightSampler;
    std::optional<Accel> accel;

    Camera camera;
    Film film;
    Filter filter;
    Sampler sampler;
    PathSettings path;
    float targetError = 0;  ///< see RenderToError; 0: all samples everywhere
    Options options;
    bool filtersTextures = false;  ///< some texture reads the steps per pixel
    bool moves = false;            ///< time matters
    std::vector<bool> plain;       ///< by material: see IsPlain

    /// Index of the light that a hit on an emissive geometry belongs to.
    static int LightOf(const Geometry &geometry, uint32_t primitive) {
        return geometry.firstLight + (geometry.oneLight ? 0 : int(primitive));
    }
    /// The hit's surface in rendering space.
    SurfacePoint Interact(const Hit &hit, const Ray &ray) const;
    /// Interact for the given lanes; the others are undefined. kWithTangents: with derivatives, uv
    /// and faceIndex.
    template <bool kWithTangents>
    SurfacePoints Interact(const HitPacket &hits, const RayPacket &rays, LaneBits lanes) const;
    /// Point and frames only; see pbrt::InteractLightly.
    SurfacePoint InteractLightly(const Hit &hit, const Ray &ray) const;
    TextureEvalContext TextureContext(const SurfacePoint &sp) const;
    /// TextureContext for the given lanes.
    void TextureContexts(const SurfacePoints &sp, LaneBits lanes,
                         std::array<TextureEvalContext, kWide> *contexts) const;

    const MixMaterial *AsMix(MaterialId id) const {
        return id >= kFirstMix ? &mixes[id - kFirstMix] : nullptr;
    }
    /// The material that a ray of direction d meets, where `id` is a mix.
    MaterialId MaterialMet(MaterialId id, const SurfacePoint &sp, Vector3f d) const {
        while (const MixMaterial *mix = AsMix(id))
            [[unlikely]] id = mix->Choose(TextureContext(sp), d, id);
        return id;
    }
    /// Geometries below this stand in the scene as they are; the others only in instances.
    uint32_t TopLevelGeometries() const;
    /// True if light passes straight through; false for materials that could not be made, and for
    /// all where Option "forcediffuse" makes them matt.
    bool LetsLightThrough(MaterialId id) const;

  private:
    template <typename T>
    TextureFootprint<T> FootprintAt(const SurfacePointT<T> &sp) const;
};

}  // namespace pbrt
