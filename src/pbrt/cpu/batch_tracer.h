#pragma once

#include "pbrt/cpu/first_seen.h"
#include "pbrt/cpu/gaps.h"
#include "pbrt/cpu/path_batch.h"
#include "pbrt/cpu/vertices.h"

namespace pbrt {

/// Traces a batch of paths side by side, one vertex of each at a time: rays go through Embree in
/// packets, and what a packet's sixteen paths do alike is done at once. Every path's result depends
/// on nothing but its pixel and sample number, and, in its roundings, on the paths that share its
/// packets: which these are depends on the scene and the picture's bounds, not on threads. Large
/// (two megabytes): one a thread, on the heap.
template <typename SamplerT, typename Scattering = BSDFAsItIs>
class BatchTracer {
  public:
    BatchTracer(const World &world, const SamplerT &sampler)
        : world(world), sampler(sampler), choosesLights(!world.lightSampler.OnlyLight()) {
        for (PathQueue &queue : paths.queues)
            queue.KeepNormals(world.lightSampler.ReadsNormals());
        for (const Geometry &g : world.geometries) {
            materialOf.push_back(uint32_t(g.material));
            kindOf.push_back(world.AsMix(g.material) ? kMix : KindOf(uint32_t(g.material)));
        }
    }

    /// Adds the samples to the pixels' sums; batch.Size() <= kBatchSize.
    void Trace(const Batch &what, std::span<Film::Pixel> sums, RayCounts &counts) {
        DCHECK(what.Size() <= kBatchSize);
        batch = what;
        rays = &counts;
        sampler.StartBatch(batch.pixels);
        StartPaths();
        for (int dimension = kFirstVertexDimension; paths.queue->Size() > 0;
             dimension += VertexNumbers::kDimensions)
            Step(dimension);
        Develop(sums);
    }

  private:
    static constexpr size_t kTypes = std::variant_size_v<Material>;
    static constexpr uint32_t kMix = ~0u;  ///< the kind of no path
    // Dimensions of the camera's numbers.
    static constexpr int kWavelength = 0, kFilm = 1, kTime = 2, kLens = 3,
                         kFirstVertexDimension = 4;

    void StartPaths() {
        uint32_t slot = 0;
        for (uint32_t pixel = 0; pixel < batch.pixels.size(); ++pixel)
            for (int k = batch.firstSample; k < batch.lastSample; ++k, ++slot)
                paths.pixel[slot] = pixel, paths.sample[slot] = uint32_t(k);
        // The last packet draws for lanes that do not count.
        std::fill_n(&paths.pixel[slot], kWide, 0u);
        paths.queue->Clear();
        for (uint32_t first = 0; first < slot; first += kWide)
            StartPaths(first, int(std::min(uint32_t(kWide), slot - first)));
    }
    void StartPaths(uint32_t first, int count) {
        const WideUint pixel = LoadWide(&paths.pixel[first]), k = LoadWide(&paths.sample[first]);
        const bool jitters = !world.options.disablePixelJitter;
        const WideFloat half = Broadcast16(0.5f);
        const WideFloat uLambda =
            world.options.disableWavelengthJitter ? half : sampler.Get1D(kWavelength, pixel, k);
        const WidePoint2f uFilm = sampler.Get2D(kFilm, pixel, k);
        WideFloat time{};
        if (world.moves) time = jitters ? sampler.Get1D(kTime, pixel, k) : half;
        WidePoint2f uLens{half, half};
        if (world.camera.HasLens() && jitters) uLens = sampler.Get2D(kLens, pixel, k);
        WidePoint2f film;
        for (int i = 0; i < kWide; ++i) {
            const FilterSample f =
                jitters ? Sample(world.filter, Lane(uFilm, i)) : FilterSample{{}, 1};
            const Point2i at = batch.pixels[pixel[i]];
            filterWeight[first + uint32_t(i)] = f.weight;
            SetLane(&film, i, {at.x + 0.5f + f.p.x, at.y + 0.5f + f.p.y});
        }
        const RayPacket packet = world.camera.GenerateRays(film, uLens, time);
        PathLanes path{};
        path.slot = kLaneNumbers + first;
        path.o = packet.o, path.d = packet.d, path.time = packet.time;
        path.etaScale = Broadcast16(1.f);
        path.beta.fill(SampledSpectrum(1));
        paths.queue->Add(path, FirstLanes(count));
        for (int i = 0; i < count; ++i)
            StartPath(first + uint32_t(i), uLambda[i], packet.At(i));
    }
    void StartPath(uint32_t slot, float uLambda, const Ray &ray) {
        paths.lambda[slot] = world.film.SampleWavelengths(uLambda);
        paths.L[slot] = SampledSpectrum(0);
        if (world.film.WantsSurface()) [[unlikely]]
            seen[slot] = FirstSeen(world, ray, paths.lambda[slot]);
    }

    /// One vertex of every path in the queue. Paths that meet the same kind of surface follow one
    /// another: their code and its branches are the same.
    void Step(int dimension) {
        paths.shadows.Clear();
        paths.next->Clear();
        for (PathList &list : lists)
            list.size = 0;
        const bool fromCamera = dimension == kFirstVertexDimension;
        if (!fromCamera) SortByOctant(*paths.queue);
        for (int first = 0; first < paths.queue->Size(); first += kWide)
            Intersect(first, fromCamera);
        for (size_t kind = 0; kind < lists.size(); ++kind) {
            const PathList &list = lists[kind];
            for (int first = 0; first < list.size; first += kWide)
                Meet(kind, &list.at[size_t(first)], std::min(kWide, list.size - first), dimension);
        }
        TraceShadows();
        std::swap(paths.queue, paths.next);
    }

    /// Sets `order` to the places in the queue, octant by octant.
    template <typename Queue>
    void SortByOctant(const Queue &queue) {
        const int n = queue.Size();
        std::array<uint32_t, 9> end{};
        for (int first = 0; first < n; first += kWide)
            StoreWide(Octant(queue.Directions(first)), &octant[size_t(first)]);
        for (int i = 0; i < n; ++i)
            ++end[octant[size_t(i)] + 1];
        for (size_t k = 1; k < end.size(); ++k)
            end[k] += end[k - 1];
        for (int i = 0; i < n; ++i)
            order[end[octant[size_t(i)]]++] = uint32_t(i);
        std::fill_n(&order[size_t(n)], kWide, 0u);
    }

    void Intersect(int first, bool fromCamera) {
        const int count = std::min(kWide, paths.queue->Size() - first);
        const WideUint place =
            fromCamera ? kLaneNumbers + uint32_t(first) : LoadWide(&order[size_t(first)]);
        const RayPacket packet = paths.queue->RaysAt(place);
        HitPacket hits;
        const LaneBits met = world.accel->Intersect(
            packet, FirstLanes(count), &hits, fromCamera ? Coherence::Alike : Coherence::Octant);
        rays->closest += count;
        paths.SetHits(place, hits, met);
        const WideUint geometry = Select(MaskOf(met), hits.geometry, WideUint{});
        WideUint material = met ? Gather(materialOf.data(), geometry) : WideUint{};
        WideUint kind = met ? Gather(kindOf.data(), geometry) : WideUint{};
        ForEachLane(met & BitsOf(kind == kMix), [&](int i) {
            const Ray ray = packet.At(i);
            material[i] = uint32_t(
                world.MaterialMet(MaterialId(material[i]), world.Interact(hits.At(i), ray), ray.d));
            kind[i] = KindOf(material[i]);
        });
        Scatter(&paths.material[0], place, material, met);
        kind = Select(MaskOf(met), kind, WideUint{});
        for (int i = 0; i < count; ++i) {
            PathList &list = lists[kind[i]];
            list.at[size_t(list.size++)] = place[i];
        }
    }

    /// Which list paths belong to that meet this material.
    uint32_t KindOf(uint32_t material) const {
        return uint32_t(1 + 2 * world.materials[material].index() + world.plain[material]);
    }

    /// Paths at the given places of the queue, all of one kind.
    void Meet(size_t kind, const uint32_t *from, int count, int dimension) {
        const WideUint at = Select(MaskOf(FirstLanes(count)), LoadWide(from), Broadcast16(from[0]));
        if (kind == 0) {
            if (world.infiniteLights.empty()) return;
            return AddLightFromInfinity(world, paths.queue->At(at), FirstLanes(count), &paths);
        }
        const WideUint slot = paths.queue->SlotsAt(at);
        const WideUint pixel = Gather(&paths.pixel[0], slot), k = Gather(&paths.sample[0], slot);
        ForType(kind - 1, [&]<typename M, bool kPlain>() {
            const auto numbers =
                VertexNumbers::Draw(sampler, dimension, pixel, k, {choosesLights, !HasOneLobe<M>});
            Vertices<M, kPlain, Scattering>(world, paths, numbers).Meet(at, count);
        });
    }
    /// Calls f<M, kPlain>() for the kind 2 * index of M in Material + kPlain.
    template <typename F, size_t... K>
    static void ForType(size_t kind, const F &f, std::index_sequence<K...>) {
        const auto call = [&]<size_t k>() {
            using M = std::variant_alternative_t<k / 2, Material>;
            if constexpr (k % 2 == 0 || requires(const M &m) { m.IsPlain(); })
                f.template operator()<M, k % 2 == 1>();
        };
        (void)((kind == K && (call.template operator()<K>(), true)) || ...);
    }
    template <typename F>
    static void ForType(size_t kind, const F &f) {
        ForType(kind, f, std::make_index_sequence<2 * kTypes>());
    }

    void TraceShadows() {
        ShadowQueue &shadows = paths.shadows;
        rays->shadow += shadows.Size();
        SortByOctant(shadows);
        for (int first = 0; first < shadows.Size(); first += kWide) {
            const LaneBits lanes = FirstLanes(shadows.Size() - first);
            const uint32_t *const place = &order[size_t(first)];
            const RayPacket packet = shadows.RaysAt(LoadWide(place));
            const auto gain = [&](int i, float share) {
                paths.L[shadows.Slot(place[i])] += shadows.Gain(place[i]) * share;
            };
            if (world.accel->HasGaps()) {
                WideFloat passed;
                world.accel->Transmittance(packet, lanes, GapsOf(world), &passed);
                ForEachLane(lanes, [&](int i) { gain(i, passed[i]); });
            } else {
                const LaneBits dark = world.accel->Occluded(packet, lanes);
                ForEachLane(lanes & ~dark, [&](int i) { gain(i, 1); });
            }
        }
    }

    void Develop(std::span<Film::Pixel> sums) {
        const bool surfaces = world.film.WantsSurface();
        uint32_t slot = 0;
        for (Film::Pixel &pixel : sums) {
            for (int k = 0; k < batch.SamplesPerPixel(); ++k, ++slot) {
                SampledSpectrum &L = paths.L[slot];
                // Never seen in tests; a picture must not lose a pixel to one path.
                if (!L.IsFinite()) L = SampledSpectrum(0);
                world.film.AddSample(&pixel, L, paths.lambda[slot], filterWeight[slot],
                                     surfaces && seen[slot] ? &*seen[slot] : nullptr);
            }
        }
    }

    const World &world;
    SamplerT sampler;
    const bool choosesLights;
    RayCounts *rays = nullptr;
    Batch batch;
    PathBatch paths;
    std::vector<uint32_t> materialOf, kindOf;  ///< by geometry
    BatchArray<uint32_t> octant, order;
    /// Places in the queue.
    struct PathList {
        BatchArray<uint32_t> at;
        int size = 0;
    };
    /// Rays that left the scene, then by type of material, those that are not plain first.
    std::array<PathList, 1 + 2 * kTypes> lists;
    BatchArray<float> filterWeight;  ///< by slot, as is the next
    BatchArray<std::optional<VisibleSurface>> seen;
};

}  // namespace pbrt
