#pragma once

#include "pbrt/cpu/first_seen.h"
#include "pbrt/cpu/gaps.h"
#include "pbrt/cpu/path_batch.h"
#include "pbrt/cpu/surface_kinds.h"
#include "pbrt/cpu/vertex.h"
#include "pbrt/cpu/wide_vertex.h"

namespace pbrt {

/// Traces a batch of paths side by side, one vertex of each at a time: rays go through Embree in
/// packets, and what a packet's sixteen paths do alike is done at once. Every path's result depends
/// on nothing but its pixel and sample number. Large (a megabyte): one a thread, on the heap.
template <typename SamplerT, typename Scattering = BSDFAsItIs>
class BatchTracer {
  public:
    BatchTracer(const World &world, const SamplerT &sampler)
        : world(world), sampler(sampler), kinds(world) {}

    /// Adds the samples to the pixels' sums; batch.Size() <= kBatchSize.
    void Trace(const Batch &what, std::span<Film::Pixel> sums, RayCounts &counts) {
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
            StartPaths(first, std::min(uint32_t(kWide), slot - first));
    }
    void StartPaths(uint32_t first, uint32_t count) {
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
        for (uint32_t i = 0; i < count; ++i) {
            const FilterSample onFilm =
                jitters ? Sample(world.filter, {uFilm.x[i], uFilm.y[i]}) : FilterSample{{0, 0}, 1};
            StartPath(first + i, uLambda[i], onFilm, {uLens.x[i], uLens.y[i]}, time[i]);
        }
    }
    void StartPath(uint32_t slot, float uLambda, const FilterSample &onFilm, Point2f lens,
                   float time) {
        const Point2i pixel = batch.pixels[paths.pixel[slot]];
        paths.lambda[slot] = world.film.SampleWavelengths(uLambda);
        paths.L[slot] = SampledSpectrum(0);
        filterWeight[slot] = onFilm.weight;
        PathState path;
        path.beta = SampledSpectrum(1);
        path.ray = world.camera.GenerateRay(
            {pixel.x + 0.5f + onFilm.p.x, pixel.y + 0.5f + onFilm.p.y}, lens, time);
        paths.queue->Add(slot, path);
        if (world.film.WantsSurface()) [[unlikely]]
            seen[slot] = FirstSeen(world, path.ray, paths.lambda[slot]);
    }

    /// One vertex of every path in the queue. Paths that meet the same kind of surface follow one
    /// another: their code and its branches are the same.
    void Step(int dimension) {
        paths.shadows.Clear();
        paths.next->Clear();
        for (PathList &list : lists)
            list.size = 0;
        for (int first = 0; first < paths.queue->Size(); first += kWide)
            Intersect(first, std::min(kWide, paths.queue->Size() - first));
        for (int kind = 0; kind < SurfaceKinds::kMost; ++kind) {
            const PathList &list = lists[size_t(kind)];
            for (int first = 0; first < list.size; first += kWide)
                Meet(kind, &list.at[size_t(first)], std::min(kWide, list.size - first), dimension);
        }
        TraceShadows();
        std::swap(paths.queue, paths.next);
    }

    void Intersect(int first, int count) {
        HitPacket &packet = paths.hits[size_t(first / kWide)];
        const LaneBits met =
            world.accel->Intersect(paths.queue->Rays(first), FirstLanes(count), &packet);
        rays->closest += count;
        for (int i = 0; i < count; ++i) {
            const int kind = met >> i & 1 ? kinds.Of(packet.geometry[i]) : SurfaceKinds::kNone;
            PathList &list = lists[size_t(kind)];
            list.at[size_t(list.size++)] = uint32_t(first + i);
        }
    }

    /// Paths at the given places of the queue, all of one kind.
    void Meet(int kind, const uint32_t *at, int count, int dimension) {
        if (kind == SurfaceKinds::kNone) {
            if (world.infiniteLights.empty()) return;
            for (int i = 0; i < count; ++i)
                MeetOne(int(at[i]), [](auto &vertex) { return vertex.Miss(), false; });
            return;
        }
        WideUint places, slots, pixel, k;
        for (int i = 0; i < kWide; ++i) {
            places[i] = at[std::min(i, count - 1)];
            slots[i] = paths.queue->slot[places[i]];
            pixel[i] = paths.pixel[slots[i]];
            k[i] = paths.sample[slots[i]];
        }
        VertexDraws<SamplerT> draws{sampler, dimension, pixel, k};
        if (kind == SurfaceKinds::kWideDiffuse) {
            WideVertex<SamplerT>(world, paths, draws).Meet(places, slots, count);
            return;
        }
        const WideFloat light = draws.Light(), lobe = draws.Lobe(), roulette = draws.Roulette();
        const WidePoint2f point = draws.LightPoint(), direction = draws.Direction();
        for (int i = 0; i < count; ++i) {
            const VertexNumbers numbers{light[i],
                                        {point.x[i], point.y[i]},
                                        lobe[i],
                                        {direction.x[i], direction.y[i]},
                                        roulette[i]};
            MeetOne(int(at[i]), [&](auto &vertex) {
                return vertex.Meet(paths.HitOf(int(at[i])), numbers);
            });
        }
    }
    template <typename F>
    void MeetOne(int at, const F &meet) {
        const uint32_t slot = paths.queue->slot[size_t(at)];
        PathState path = paths.queue->At(at);
        ShadowTest shadow;
        PathVertex<Scattering> vertex(world, path, paths.lambda[slot], paths.L[slot], shadow);
        const bool goesOn = meet(vertex);
        if (shadow.light) paths.shadows.Add(slot, path.ray.time, shadow);
        if (goesOn) paths.next->Add(slot, path);
    }

    void TraceShadows() {
        ShadowQueue &shadows = paths.shadows;
        rays->shadow += shadows.Size();
        for (int first = 0; first < shadows.Size(); first += kWide) {
            const LaneBits lanes = FirstLanes(shadows.Size() - first);
            const RayPacket packet = shadows.Rays(first);
            const auto gain = [&](int i, float share) {
                paths.L[shadows.slot[size_t(first + i)]] += shadows.light[size_t(first + i)] * share;
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
    RayCounts *rays = nullptr;
    Batch batch;
    PathBatch paths;
    SurfaceKinds kinds;
    /// Places in the queue.
    struct PathList {
        BatchArray<uint32_t> at;
        int size = 0;
    };
    std::array<PathList, SurfaceKinds::kMost> lists;  ///< by kind
    BatchArray<float> filterWeight;                   ///< by slot, as is the next
    BatchArray<std::optional<VisibleSurface>> seen;
};

}  // namespace pbrt
