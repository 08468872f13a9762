#include "pbrt/accel/accel.h"

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "pbrt/accel/impl.h"

namespace pbrt {

namespace {

void NoteError(void *user, RTCError code, const char *text) {
    static_cast<EmbreeFailure *>(user)->Note(code, text);
}

bool NoteMemory(void *user, ssize_t bytes, bool) {
    static_cast<MemoryUse *>(user)->Add(bytes);
    return true;
}

/// Null for shapes in rendering space.
const Transform *ObjectSpace(const Shape &shape) {
    return Dispatch(shape, []<typename S>(const S &s) -> const Transform * {
        if constexpr (S::kTraits.hasObjectSpace)
            return &s.renderFromObject;
        else
            return nullptr;
    });
}

bool IsInvisible(const Geometry &g) {
    return g.alpha.IsConstant() && g.alpha.Constant() <= 0;
}

struct InstructionSet {
    const char *name;  ///< as Embree spells it
    bool known;        ///< to this processor
};

/// Embree's instruction sets. Embree itself does not ask the processor when it is told one.
std::vector<InstructionSet> InstructionSets() {
#if defined(__x86_64__)
    return {
        {"sse4.2", bool(__builtin_cpu_supports("sse4.2"))},
        {"avx", bool(__builtin_cpu_supports("avx"))},
        {"avx2", bool(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))},
        {"avx512", bool(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512vl"))}};
#else
    return {};
#endif
}

/// Embree's device configuration. The environment variable PBRT_EMBREE_ISA names the instruction
/// set, for tests of what other processors do; without it Embree takes the widest that there is. On
/// an unknown name *error says which there are.
std::string DeviceConfiguration(int nThreads, std::string *error) {
    std::string config = nThreads > 0 ? fmt::format("threads={}", nThreads) : "";
    const char *const asked = std::getenv("PBRT_EMBREE_ISA");
    if (!asked || !*asked) return config;
    std::string names;
    for (const InstructionSet &isa : InstructionSets()) {
        if (!isa.known) continue;
        if (isa.name == std::string_view(asked))
            return fmt::format("{}{}isa={}", config, config.empty() ? "" : ",", isa.name);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", isa.name);
    }
    *error = fmt::format("PBRT_EMBREE_ISA is \"{}\"; this processor knows: {}", asked, names);
    return {};
}

/// Returns memory freed in small pieces to the system, which does not happen by itself.
void ReturnFreeMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace

void EmbreeFailure::Note(RTCError error, const char *why) {
    if (code != RTC_ERROR_NONE) return;
    code = error;
    if (why) std::strncpy(text.data(), why, text.size() - 1);
}

std::string EmbreeFailure::Sentence() const {
    if (code == RTC_ERROR_OUT_OF_MEMORY) return "not enough memory for the ray tracing structure";
    return fmt::format("Embree: {} (error {})", text.data(), int(code));
}

Accel::Impl::~Impl() {
    if (scene) rtcReleaseScene(scene);
    for (RTCScene s : objectScenes)
        if (s) rtcReleaseScene(s);
    if (device) rtcReleaseDevice(device);
}

void Accel::Impl::Build(int nThreads) {
    const std::string config = DeviceConfiguration(nThreads, &error);
    if (!error.empty()) return;
    device = rtcNewDevice(config.c_str());
    if (!device) {
        failure.Note(rtcGetDeviceError(nullptr), "it does not start");
        error = failure.Sentence();
        return;
    }
    rtcSetDeviceErrorFunction(device, NoteError, &failure);
    rtcSetDeviceMemoryMonitorFunction(device, NoteMemory, &memory);
    BuildScenes();
    if (Failed()) error = failure.Sentence();
}

void Accel::Impl::BuildScenes() {
    records.reserve(geometries.size());
    for (const Geometry &g : geometries) {
        const bool hasAlpha = !g.alpha.IsConstant() || g.alpha.Constant() < 1;
        records.push_back({&g, uint32_t(records.size()), uint32_t(records.size()), nTop, hasAlpha});
    }
    for (const ObjectRange &object : objects) {
        objectScenes.push_back(NewScene(object.first, object.last, object.last - object.first));
        if (Failed()) return;
        rtcCommitScene(objectScenes.back());
    }
    Count(0, nTop);
    for (const Instance &instance : instances)
        Count(objects[instance.object].first, objects[instance.object].last);
    scene = NewScene(0, nTop, nTop + uint32_t(instances.size()));
    AttachInstances();
    if (Failed()) return;
    ReturnFreeMemory();  // Embree's building takes the most
    rtcCommitScene(scene);
}

void Accel::Impl::Count(uint32_t first, uint32_t last) {
    for (uint32_t i = first; i < last; ++i)
        (IsNative(geometries[i].shape) ? nOther : nUser) += NPrimitives(geometries[i].shape);
}

void Accel::Impl::Attach(RTCScene target, RTCGeometry geometry, uint32_t id) {
    // Calls on a null handle are noted nowhere; what failed before them has been.
    if (!geometry) return failure.Note(RTC_ERROR_UNKNOWN, "a geometry could not be made");
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(target, geometry, id);
    rtcReleaseGeometry(geometry);
}

/// Medium build quality: high splits triangles in space and would call filters twice for one.
/// Robust, for a tenth to a quarter of the time: without it a closed mesh of a million triangles
/// lets 1e-6 of all rays out, and 1e-4 where it is 1000 times its size from the origin.
RTCScene Accel::Impl::NewScene(uint32_t first, uint32_t last, uint32_t placedId) {
    RTCScene s = rtcNewScene(device);
    if (!s) return failure.Note(RTC_ERROR_UNKNOWN, "a scene could not be made"), nullptr;
    rtcSetSceneBuildQuality(s, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSceneFlags(s, RTC_SCENE_FLAG_ROBUST);
    PlacedSet set;
    set.reserve(size_t(std::count_if(geometries.begin() + first, geometries.begin() + last,
                                     [](const Geometry &g) { return ObjectSpace(g.shape); })));
    for (uint32_t i = first; i < last && !Failed(); ++i) {
        GeometryRecord &record = records[i];
        record.local = i - first;
        if (IsInvisible(*record.geometry)) continue;
        if (const Transform *const renderFromObject = ObjectSpace(record.geometry->shape))
            set.emplace_back(record, *renderFromObject);
        else
            Attach(s, NewGeometry(record), record.local);
    }
    if (!set.empty()) {
        placed.push_back(std::move(set));
        Attach(s, NewPlaced(device, &placed.back()), placedId);
    }
    return s;
}

void Accel::Impl::AttachInstances() {
    resting = {instances, objectScenes, nTop, {}};
    for (uint32_t i = 0; i < instances.size() && !Failed(); ++i)
        if (instances[i].Moves() || instances.size() <= kMostEmbreeInstances)
            AttachInstance(i);
        else
            resting.resting.push_back(i);
    // The ID behind that of the last instance is NewScene's.
    if (!resting.resting.empty())
        Attach(scene, NewInstances(device, &resting), nTop + uint32_t(instances.size()) + 1);
}

void Accel::Impl::AttachInstance(uint32_t index) {
    const Instance &instance = instances[index];
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, objectScenes[instance.object]);
    rtcSetGeometryTimeStepCount(geometry, unsigned(instance.NKeys()));
    for (size_t k = 0; k < instance.NKeys(); ++k)
        rtcSetGeometryTransform(geometry, unsigned(k), RTC_FORMAT_FLOAT3X4_ROW_MAJOR,
                                instance.Key(k).Matrix().data());
    Attach(scene, geometry, nTop + index);
}

Accel::Accel(std::span<const Geometry> geometries, uint32_t nTop,
             std::span<const ObjectRange> objects, std::span<const Instance> instances,
             int nThreads)
    : impl(std::make_unique<Impl>(geometries, nTop, objects, instances)) {
    for (const Geometry &g : geometries)
        hasNullTransmission |= g.hasNullTransmission && !IsInvisible(g);
    impl->Build(nThreads);
}

Accel::~Accel() = default;
Accel::Accel(Accel &&) noexcept = default;
Accel &Accel::operator=(Accel &&) noexcept = default;

const std::string &Accel::Error() const {
    return impl->error;
}

Bounds3f Accel::WorldBounds() const {
    RTCBounds b;
    rtcGetSceneBounds(impl->scene, &b);
    return {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
}

size_t Accel::MemoryBytes() const {
    return size_t(std::max<int64_t>(0, impl->memory.now));
}

size_t Accel::PeakMemoryBytes() const {
    return size_t(impl->memory.most);
}

}  // namespace pbrt
