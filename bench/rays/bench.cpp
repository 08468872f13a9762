// Rays per second of one thread against Embree alone, on the rays that diffuse paths take through a
// scene: camera rays and up to four cosine-distributed bounces, in the order of their tracing. Then
// single rays against packets of 16, for each kind of ray.
//   bench_rays scene.pbrt [rounds, default 9]

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "bench/rays/ray_kinds.h"
#include "bench/stopwatch.h"
#include "pbrt/accel/embree_scene.h"
#include "pbrt/accel/query.h"
#include "pbrt/build/build_scene.h"
#include "pbrt/scene/parser.h"

namespace pbrt::bench {
namespace {

constexpr int kPaths = 100000, kMaxBounces = 4;

/// Calls each(ray) for each ray of the paths; each traces it and says whether and what it hits.
template <typename Each>
double FollowPaths(const RenderScene &world, const Each &each) {
    const Point2i resolution = world.film.FullResolution();
    Rng rng(1);
    double sum = 0;
    for (int k = 0; k < kPaths; ++k) {
        const Point2f film{rng.Uniform() * resolution.x, rng.Uniform() * resolution.y};
        Ray ray = GenerateRay(world.camera, film, {0.5f, 0.5f}, 0);
        for (int bounce = 0; bounce <= kMaxBounces; ++bounce) {
            Hit hit;
            if (!each(ray, &hit)) break;
            const SurfaceInteraction sp = world.SurfaceAt(hit, ray);
            sum += hit.t;
            Vector3f n = sp.n;
            if (Dot(n, ray.d) > 0) n = -n;
            const Vector3f w = SampleCosineHemisphere(rng.Uniform2D());
            ray.d = Frame::FromZ(n).FromLocal(w);
            ray.o = sp.OffsetOrigin(ray.d);
            ray.tMax = Infinity;
        }
    }
    return sum;
}

/// The plain loop over rtcIntersect1 with the rays ready in memory.
double TraceBare(const std::vector<RTCRayHit> &rays, const std::vector<Ray> &own, RTCScene scene) {
    double sum = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        RTCRayHit rh = rays[i];
        QueryContext context(own[i], nullptr, nullptr);
        Intersect1(scene, &context.embree, &rh);
        sum += rh.hit.geomID == RTC_INVALID_GEOMETRY_ID ? 0 : rh.ray.tfar;
    }
    return sum;
}

RTCRayHit ToEmbree(const Ray &ray) {
    RTCRayHit rh{};
    rh.ray.org_x = ray.o.x, rh.ray.org_y = ray.o.y, rh.ray.org_z = ray.o.z;
    rh.ray.dir_x = ray.d.x, rh.ray.dir_y = ray.d.y, rh.ray.dir_z = ray.d.z;
    rh.ray.tnear = std::numeric_limits<float>::min(), rh.ray.tfar = ray.tMax;
    rh.ray.mask = ~0u;
    rh.hit.geomID = rh.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return rh;
}

void Compare(const RenderScene &world, int rounds) {
    const Accel &accel = *world.accel;
    std::vector<Ray> rays;
    FollowPaths(world, [&](const Ray &ray, Hit *hit) {
        rays.push_back(ray);
        return accel.Intersect(ray, hit);
    });
    std::vector<RTCRayHit> bare;
    for (const Ray &ray : rays)
        bare.push_back(ToEmbree(ray));
    const auto scene = EmbreeSceneOf(accel).scene;
    const int n = int(rays.size());
    Stopwatch watch;
    watch.Add("rtcIntersect1 alone", n, [&] { return TraceBare(bare, rays, scene); });
    watch.Add("Accel::Intersect", n, [&] {
        double sum = 0;
        Hit hit;
        for (const Ray &ray : rays)
            sum += accel.Intersect(ray, &hit) ? hit.t : 0;
        return sum;
    });
    watch.Add("paths without shading", n, [&] {
        return FollowPaths(world,
                           [&](const Ray &ray, Hit *hit) { return accel.Intersect(ray, hit); });
    });
    watch.Run(rounds);
    const double limit = watch.Nanoseconds("rtcIntersect1 alone");
    std::printf("%d rays\n", n);
    for (const char *name : {"rtcIntersect1 alone", "Accel::Intersect", "paths without shading"})
        std::printf("%-22s %7.1f ns  %6.2f M rays/s  %3.0f %%\n", name, watch.Nanoseconds(name),
                    1e3 / watch.Nanoseconds(name), 100 * limit / watch.Nanoseconds(name));
}

void Report(const Stopwatch &watch, const RayKind &kind, const char *query) {
    const std::string name = fmt::format("{} {}", kind.name, query);
    const double single = watch.Nanoseconds(name), packet = watch.Nanoseconds(name + " 16");
    std::printf("%-27s %7.1f ns single  %7.1f ns in packets  %5.2f x  (%zu rays)\n", name.c_str(),
                single, packet, single / packet, kind.rays.size());
}

void AddIntersections(Stopwatch *watch, const Accel &accel, const RayKind &kind,
                      Coherence coherence) {
    const int n = int(kind.rays.size());
    const std::string name = fmt::format("{} Intersect", kind.name);
    watch->Add(name, n, [&] {
        double sum = 0;
        Hit hit;
        for (const Ray &ray : kind.rays)
            sum += accel.Intersect(ray, &hit) ? hit.t : 0;
        return sum;
    });
    watch->Add(name + " 16", n, [&, coherence] {
        FloatX16 sum{};
        HitPacket hits{};
        for (size_t i = 0; i < kind.packets.size(); ++i)
            sum +=
                Select(MaskOf(accel.Intersect(kind.packets[i], kind.active[i], &hits, coherence)),
                       hits.t, 0.f);
        return double(sum[0]);
    });
}

void AddOcclusions(Stopwatch *watch, const Accel &accel, const RayKind &kind) {
    const int n = int(kind.rays.size());
    const std::string name = fmt::format("{} Occluded", kind.name);
    watch->Add(name, n, [&] {
        int blocked = 0;
        for (const Ray &ray : kind.rays)
            blocked += accel.Occluded(ray);
        return double(blocked);
    });
    watch->Add(name + " 16", n, [&] {
        int blocked = 0;
        for (size_t i = 0; i < kind.packets.size(); ++i)
            blocked += std::popcount(accel.Occluded(kind.packets[i], kind.active[i]));
        return double(blocked);
    });
}

void ComparePackets(const RenderScene &world, int rounds) {
    const RayKinds kinds(world);
    Stopwatch watch;
    AddIntersections(&watch, *world.accel, kinds.camera, Coherence::Alike);
    AddIntersections(&watch, *world.accel, kinds.bounce, Coherence::None);
    AddIntersections(&watch, *world.accel, kinds.byOctant, Coherence::Octant);
    AddOcclusions(&watch, *world.accel, kinds.shadow);
    watch.Run(rounds);
    Report(watch, kinds.camera, "Intersect");
    Report(watch, kinds.bounce, "Intersect");
    Report(watch, kinds.byOctant, "Intersect");
    Report(watch, kinds.shadow, "Occluded");
}

int Main(int argc, char **argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_rays scene.pbrt [rounds]\n");
        return 1;
    }
    Diagnostics log;
    SceneDescription scene;
    ParseFiles({argv[1]}, scene, log);
    const std::unique_ptr<RenderScene> world = BuildScene(std::move(scene), {}, log);
    for (const Message &m : log.Messages())
        std::fprintf(stderr, "%s\n", m.text.c_str());
    if (!world) return 1;
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 9;
    Compare(*world, rounds);
    ComparePackets(*world, rounds);
    return 0;
}

}  // namespace
}  // namespace pbrt::bench

int main(int argc, char **argv) {
    return pbrt::bench::Main(argc, argv);
}
