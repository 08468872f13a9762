#pragma once

#include "pbrt/build/null_transmission.h"
#include "pbrt/build/visible_surface.h"
#include "pbrt/integrators/camera_sample.h"
#include "pbrt/integrators/path/emission.h"
#include "pbrt/integrators/path/path_batch.h"
#include "pbrt/integrators/path/shade_groups.h"
#include "pbrt/integrators/tracer.h"
#include "pbrt/samplers/batch_sampler.h"

namespace pbrt {

/// Traces a batch of paths side by side, one vertex of each at a time: rays are traced in
/// packets, and what a packet's sixteen paths do alike is done at once. A path's result depends on
/// its pixel and sample number, and, in its roundings, on the paths of its batch, which share its
/// packets: so batches have the same borders whatever part of an image is rendered
/// (render/pieces.h). Large (two megabytes): one for each thread, on the heap.
template <SamplerType SamplerT>
class BatchTracer final : public Tracer {
  public:
    BatchTracer(const RenderScene &scene, const PathSettings &settings, const SamplerT &sampler,
                std::span<const ShadeGroup> groups = ShadeGroups())
        : scene(scene),
          settings(settings),
          sampler(sampler),
          choosesLights(!settings.lightSampler.OnlyLight()),
          groups(groups),
          lists(1 + groups.size()) {
        for (PathQueue &queue : paths.queues)
            queue.KeepNormals(settings.lightSampler.ReadsNormals());
        for (const Geometry &g : scene.geometries) {
            materialOf.push_back(uint32_t(g.material));
            kindOf.push_back(scene.AsMix(g.material) ? kMix
                                                     : MaterialGroup(uint32_t(g.material), g));
        }
    }

    void StartTile(std::span<const Point2i> tile) override {
        pixels.assign(tile.begin(), tile.end());
        sampler.StartBatch(pixels);
    }
    void Trace(const SampleBatch &what, std::span<Film::Pixel> sums, RayCounts &counts) override {
        DCHECK(what.Size() <= kBatchSize);
        batch = what;
        rays = &counts;
        paths.clamped = &counts.clamped;
        StartPaths();
        for (int dimension = kFirstVertexDimension; paths.queue->Size() > 0;
             dimension += VertexNumbers::kDimensions)
            TraceBounce(dimension);
        AddToFilm(sums);
    }

  private:
    static constexpr uint32_t kMix = ~0u;  ///< the kind of no path
    static constexpr int kFirstVertexDimension = CameraDimensions::kEnd;

    void StartPaths() {
        uint32_t slot = 0;
        for (int pixel = batch.firstPixel; pixel < batch.lastPixel; ++pixel)
            for (int k = batch.firstSample; k < batch.lastSample; ++k, ++slot)
                paths.pixel[slot] = uint32_t(pixel), paths.sample[slot] = uint32_t(k);
        // The last packet draws for lanes that do not count.
        std::fill_n(&paths.pixel[slot], kPacketSize, 0u);
        paths.queue->Clear();
        for (uint32_t first = 0; first < slot; first += kPacketSize)
            StartPaths(first, int(std::min(uint32_t(kPacketSize), slot - first)));
    }
    void StartPaths(uint32_t first, int count) {
        const UintX16 pixel = LoadX16(&paths.pixel[first]), k = LoadX16(&paths.sample[first]);
        const bool jitters = !scene.options.disablePixelJitter;
        const FloatX16 half = Broadcast<16>(0.5f);
        const FloatX16 uLambda = scene.options.disableWavelengthJitter
                                     ? half
                                     : sampler.Get1D(CameraDimensions::kWavelength, pixel, k);
        const Point2fX16 uFilm = sampler.Get2D(CameraDimensions::kFilm, pixel, k);
        FloatX16 time{};
        if (scene.isAnimated)
            time = jitters ? sampler.Get1D(CameraDimensions::kTime, pixel, k) : half;
        Point2fX16 uLens{half, half};
        if (HasLens(scene.camera) && jitters)
            uLens = sampler.Get2D(CameraDimensions::kLens, pixel, k);
        Point2fX16 film;
        for (int i = 0; i < kPacketSize; ++i) {
            const FilterSample f =
                jitters ? Sample(scene.filter, Lane(uFilm, i)) : FilterSample{{}, 1};
            const Point2i at = pixels[pixel[i]];
            filterWeight[first + uint32_t(i)] = f.weight;
            SetLane(&film, i, {at.x + 0.5f + f.p.x, at.y + 0.5f + f.p.y});
        }
        const RayPacket packet = GenerateRays(scene.camera, film, uLens, time);
        PathPacket path{};
        path.slot = kLaneNumbers + first;
        path.o = packet.o, path.d = packet.d, path.time = packet.time;
        path.etaScale = Broadcast<16>(1.f);
        path.beta.fill(SampledSpectrum(1));
        paths.queue->Add(path, FirstLanes(count));
        for (int i = 0; i < count; ++i)
            StartPath(first + uint32_t(i), uLambda[i], packet.At(i));
    }
    void StartPath(uint32_t slot, float uLambda, const Ray &ray) {
        paths.lambda[slot] = scene.film.SampleWavelengths(uLambda);
        paths.L[slot] = SampledSpectrum(0);
        if (scene.film.WantsSurface()) [[unlikely]]
            seen[slot] = FindVisibleSurface(scene, ray, paths.lambda[slot]);
    }

    /// One vertex of every path in the queue. Paths that meet the same kind of surface follow one
    /// another: their code and its branches are the same.
    void TraceBounce(int dimension) {
        paths.shadows.Clear();
        paths.next->Clear();
        for (PathList &list : lists)
            list.size = 0;
        const bool fromCamera = dimension == kFirstVertexDimension;
        if (!fromCamera) SortByOctant(*paths.queue);
        for (int first = 0; first < paths.queue->Size(); first += kPacketSize)
            Intersect(first, fromCamera);
        for (size_t kind = 0; kind < lists.size(); ++kind) {
            const PathList &list = lists[kind];
            for (int first = 0; first < list.size; first += kPacketSize)
                ShadePaths(kind, &list.at[size_t(first)], std::min(kPacketSize, list.size - first),
                           dimension);
        }
        TraceShadows();
        std::swap(paths.queue, paths.next);
    }

    /// Sets `order` to the places in the queue, octant by octant.
    template <typename Queue>
    void SortByOctant(const Queue &queue) {
        const int n = queue.Size();
        std::array<uint32_t, 9> end{};
        for (int first = 0; first < n; first += kPacketSize)
            Store(Octant(queue.Directions(first)), &octant[size_t(first)]);
        for (int i = 0; i < n; ++i)
            ++end[octant[size_t(i)] + 1];
        for (size_t k = 1; k < end.size(); ++k)
            end[k] += end[k - 1];
        for (int i = 0; i < n; ++i)
            order[end[octant[size_t(i)]]++] = uint32_t(i);
        std::fill_n(&order[size_t(n)], kPacketSize, 0u);
    }

    void Intersect(int first, bool fromCamera) {
        const int count = std::min(kPacketSize, paths.queue->Size() - first);
        const UintX16 place =
            fromCamera ? kLaneNumbers + uint32_t(first) : LoadX16(&order[size_t(first)]);
        const RayPacket packet = paths.queue->RaysAt(place);
        HitPacket hits;
        const LaneBits met = scene.accel->Intersect(
            packet, FirstLanes(count), &hits, fromCamera ? Coherence::Alike : Coherence::Octant);
        rays->closest += count;
        paths.SetHits(place, hits, met);
        const MaskX16 found = MaskOf(met);
        const UintX16 geometry = Select(found, hits.geometry, 0);
        // A scene may have no geometry at all.
        UintX16 material = met ? Gather(materialOf.data(), geometry) : UintX16(0);
        UintX16 kind = met ? Gather(kindOf.data(), geometry) : UintX16(0);
        ForEachLane(met & BitsOf(kind == kMix), [&](int i) {
            const Ray ray = packet.At(i);
            const MaterialId id = scene.MaterialMet(
                MaterialId(material[i]), scene.SurfaceAt(hits.At(i), ray), ray.d, paths.clamped);
            material.Set(i, uint32_t(id));
            kind.Set(i, MaterialGroup(uint32_t(id), scene.geometries[geometry[i]]));
        });
        Scatter(&paths.material[0], place, material, met);
        kind = Select(found, kind, 0);
        for (int i = 0; i < count; ++i) {
            PathList &list = lists[kind[i]];
            list.at[size_t(list.size++)] = place[i];
        }
    }

    /// Number of the list for paths that meet this material on a geometry.
    uint32_t MaterialGroup(uint32_t material, const Geometry &geometry) const {
        MaterialFacts facts = scene.materials.Facts(material);
        // Uniform materials do without uv, which the image of an area light is looked up by.
        if (geometry.firstLight >= 0 && ReadsUV(scene.lights[size_t(geometry.firstLight)]))
            facts.isUniform = false;
        return uint32_t(1 + ShadeGroup::IndexOf(facts));
    }

    /// Paths at the given places of the queue, all of one kind.
    void ShadePaths(size_t kind, const uint32_t *from, int count, int dimension) {
        const UintX16 at = Select(MaskOf(FirstLanes(count)), LoadX16(from), Broadcast<16>(from[0]));
        if (kind == 0) {
            if (scene.infiniteLights.empty()) return;
            return AddEscapedRadiance(scene, settings, paths.queue->At(at), FirstLanes(count),
                                      &paths);
        }
        const UintX16 slot = paths.queue->SlotsAt(at);
        const UintX16 pixel = Gather(&paths.pixel[0], slot), k = Gather(&paths.sample[0], slot);
        const ShadeGroup &group = groups[kind - 1];
        const auto numbers =
            VertexNumbers::Draw(sampler, dimension, pixel, k, {choosesLights, !group.oneLobe});
        group.shade(scene, settings, paths, numbers, at, count);
    }

    void TraceShadows() {
        ShadowQueue &shadows = paths.shadows;
        rays->shadow += shadows.Size();
        SortByOctant(shadows);
        for (int first = 0; first < shadows.Size(); first += kPacketSize) {
            const LaneBits lanes = FirstLanes(shadows.Size() - first);
            const uint32_t *const place = &order[size_t(first)];
            const RayPacket packet = shadows.RaysAt(LoadX16(place));
            const auto gain = [&](int i, float share) {
                paths.L[shadows.Slot(place[i])] += shadows.Gain(place[i]) * share;
            };
            if (scene.accel->HasNullTransmission()) {
                FloatX16 passed;
                scene.accel->Transmittance(packet, lanes, NullTransmissionOf(scene), &passed);
                ForEachLane(lanes, [&](int i) { gain(i, passed[i]); });
            } else {
                const LaneBits dark = scene.accel->Occluded(packet, lanes);
                ForEachLane(lanes & ~dark, [&](int i) { gain(i, 1); });
            }
        }
    }

    void AddToFilm(std::span<Film::Pixel> sums) {
        const bool surfaces = scene.film.WantsSurface();
        uint32_t slot = 0;
        for (int p = batch.firstPixel; p < batch.lastPixel; ++p) {
            Film::Samples samples(scene.film, &sums[size_t(p)]);
            for (int k = 0; k < batch.SamplesPerPixel(); ++k, ++slot) {
                SampledSpectrum &L = paths.L[slot];
                // Never seen in tests; an image must not lose a pixel to one path.
                if (!L.IsFinite()) L = SampledSpectrum(0);
                samples.Add(L, paths.lambda[slot], filterWeight[slot],
                            surfaces && seen[slot] ? &*seen[slot] : nullptr);
            }
            samples.Finish();
        }
    }

    const RenderScene &scene;
    const PathSettings &settings;
    BatchSampler<SamplerT> sampler;
    std::vector<Point2i> pixels;  ///< of the tile
    const bool choosesLights;
    RayCounts *rays = nullptr;
    SampleBatch batch;
    PathBatch paths;
    std::vector<uint32_t> materialOf, kindOf;  ///< by geometry
    BatchArray<uint32_t> octant, order;
    /// Places in the queue.
    struct PathList {
        BatchArray<uint32_t> at;
        int size = 0;
    };
    std::span<const ShadeGroup> groups;
    std::vector<PathList> lists;     ///< rays that left the scene, then by group
    BatchArray<float> filterWeight;  ///< by slot, as is the next
    BatchArray<std::optional<VisibleSurface>> seen;
};

}  // namespace pbrt
