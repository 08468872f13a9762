#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string_view>

#include "pbrt/base/plug_in.h"
#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// A receiver of light. ns: the shading normal on the side from which it takes light, 0 where it
/// takes light from all sides. time: the path's, in [0, 1].
struct LightSampleContext {
    Point3f p;
    Normal3f ns;
    float time = 0;
};

/// Sixteen receivers.
struct LightSampleContextX16 {
    Point3fX16 p;
    Normal3fX16 ns;
    FloatX16 time{};

    LightSampleContext At(int i) const { return {Lane(p, i), Lane(ns, i), time[i]}; }
};

/// Light from one sampled direction.
struct LightLiSample {
    SampledSpectrum L;
    Vector3f wi;
    float pdf;       ///< per unit solid angle; 1 for delta lights
    Point3f pLight;  ///< end of the shadow ray (already moved off the light's surface)
    bool delta;      ///< no BSDF sample can find this light: point, spot, distant, invisible area
};

/// Sixteen of LightLiSample.
struct LightLiSamples {
    std::array<SampledSpectrum, kPacketSize> L;
    Vector3fX16 wi{};
    FloatX16 pdf{};
    Point3fX16 pLight{};
    LaneBits valid = 0, delta = 0;

    void Set(int i, const LightLiSample &s) {
        L[size_t(i)] = s.L;
        SetLane(&wi, i, s.wi);
        pdf.Set(i, s.pdf);
        SetLane(&pLight, i, s.pLight);
        valid |= LaneBits(1) << i;
        delta |= LaneBits(s.delta) << i;
    }
};

/// Radiance and density of an infinite light along sixteen directions.
struct LightLePacket {
    std::array<SampledSpectrum, kPacketSize> L;
    FloatX16 pdf;  ///< PDF_Li there
};

/// Cone of directions about a unit axis; cosTheta 1: the axis alone, -1: all directions.
struct DirectionCone {
    Vector3f axis{0, 0, 1};
    float cosTheta = -1;
};

/// Place, directions and power of a light (or several), after Conty Estevez and
/// Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting".
struct LightBounds {
    Bounds3f bounds;
    DirectionCone normals;  ///< of all emitters
    float cosTheta_e = 0;   ///< cosine of how far off its normal each emitter shines
    float power = 0;
    bool twoSided = false;
};

/// Sixteen lights of one type, null in lanes without one, and the wavelengths to sample them at.
template <typename L>
using LightsOf = std::array<const L *, kPacketSize>;
using WavelengthPacket = std::array<const SampledWavelengths *, kPacketSize>;

/// Properties of a type of light. Each type announces its own by
///   static constexpr LightTraits kTraits{.isInfinite = true, ...};
/// so that a misspelt trait does not compile, and a trait whose member is missing neither. A light
/// has at most one of the first three.
struct LightTraits {
    /// Part of a shape, made by AreaLightSource (AreaLightType); the others by LightSource.
    bool isArea = false;
    /// Seen by rays that leave the scene (InfiniteLightType).
    bool isInfinite = false;
    /// Only sampling finds it: each of its samples has pdf 1 and delta true.
    bool isDelta = false;
    /// Following the BSDF finds all of it at least as well: it is never chosen for sampling, and
    /// its PDF_Li is 0.
    bool neverSampled = false;
    /// Has Preprocess, which is told the radius of the scene's bounding sphere once, before
    /// anything below is called.
    bool readsSceneRadius = false;
    /// An infinite light that looks different from different places (PlacedInfiniteLight).
    bool dependsOnPlace = false;
    /// Has a sixteen-wide SampleLi (WideLight). Without it receivers are served one by one.
    bool isWide = false;
    /// Has a sixteen-wide Le (WideInfiniteLight). Without it rays are served one by one.
    bool isWideSeen = false;
};

/// The contract of lights. A light is a plain struct, cheap to copy (what is large is shared), and
/// immutable but for Preprocess. All places are in rendering space. Units are pbrt's: spectra have
/// a CIE-Y integral of 1 for one unit of RGB, and are scaled by the light's own scale.
///
///   kName, kExamples
///       see PlugInType; of several of one name the first in the list is created. The tests run
///       every law about lights on each example, on some shapes where it is an area light. An
///       image "example.exr", square, stands where they are read.
///   static constexpr LightTraits kTraits
///   static Made Create(ParamDict &, const Transform &renderFromLight)
///   static Made Create(ParamDict &, const Transform &renderFromLight,
///                      const Transform &renderFromWorld)
///   static std::vector<L> Create(ParamDict &, const EmitterArguments &)
///       the second where parameters are places in the world; the third for area lights: one light
///       a primitive of the shape. Made
///       is L, std::optional<L>, or an optional variant of lights. Empty after an error, which is
///       in the log with its place.
///   std::optional<LightLiSample> SampleLi(const LightSampleContext &, Point2f u,
///                                         const SampledWavelengths &) const
///       light from one direction, u in [0, 1)^2; nullopt where nothing arrives. Occlusion is the
///       caller's. ctx.ns may be used to sample better and need not be.
///   float Power() const
///       luminous flux, for choosing lights: to a factor of a few is enough, but 0 only where the
///       light gives nothing.
///   std::optional<LightBounds> Bounds() const
///       nullopt for light from infinity; else of all that SampleLi may draw, at any time.
template <typename L>
concept BasicLight = PlugInType<L> && std::copyable<L> &&
    requires(const L l, const LightSampleContext &ctx, Point2f u,
             const SampledWavelengths &lambda) {
    { L::kTraits } -> std::same_as<const LightTraits &>;
    { l.SampleLi(ctx, u, lambda) } -> std::same_as<std::optional<LightLiSample>>;
    { l.Power() } -> std::same_as<float>;
    { l.Bounds() } -> std::same_as<std::optional<LightBounds>>;
};

/// A light with isArea.
///   SampledSpectrum L(Point3f p, Normal3f n, Point2f uv, Vector3f w,
///                     const SampledWavelengths &) const
///       radiance that leaves the surface at a hit (of SurfaceInteraction: p, n, uv) into the unit
///       direction w.
///   float PDF_Hit(const LightSampleContext &, Point3f p, Normal3f n) const
///       density of SampleLi per unit solid angle for the direction from the receiver that meets
///       the light's primitive at p, where its normal is n.
///   bool ReadsUV() const
///       whether L looks at uv, which then are worked out.
template <typename T>
concept AreaLightType = requires(const T l, const LightSampleContext &ctx, Point3f p, Normal3f n,
                                 Point2f uv, Vector3f w, const SampledWavelengths &lambda) {
    { l.L(p, n, uv, w, lambda) } -> std::same_as<SampledSpectrum>;
    { l.PDF_Hit(ctx, p, n) } -> std::same_as<float>;
    { l.ReadsUV() } -> std::same_as<bool>;
};

/// A light with isInfinite.
///   SampledSpectrum Le(Vector3f d, const SampledWavelengths &) const
///       radiance along a ray of direction d, of any length, that leaves the scene.
///   float PDF_Li(Vector3f wi) const
///       density of SampleLi per unit solid angle for the unit direction wi, the same everywhere.
template <typename T>
concept InfiniteLightType = requires(const T l, Vector3f d, const SampledWavelengths &lambda) {
    { l.Le(d, lambda) } -> std::same_as<SampledSpectrum>;
    { l.PDF_Li(d) } -> std::same_as<float>;
};

/// A light with dependsOnPlace: Le and PDF_Li as above, for a ray from `from` and the receiver
/// `from`.
template <typename T>
concept PlacedInfiniteLight = requires(const T l, Point3f from, Vector3f d,
                                       const SampledWavelengths &lambda) {
    { l.Le(from, d, lambda) } -> std::same_as<SampledSpectrum>;
    { l.PDF_Li(from, d) } -> std::same_as<float>;
};

/// A light with isWide.
///   static LaneBits SampleLi(const LightsOf<L> &, const LightSampleContextX16 &,
///                            const Point2fX16 &u, const WavelengthPacket &, LaneBits lanes,
///                            LightLiSamples *samples)
///       SampleLi in those of the given lanes where it is worth its while, which are returned; the
///       rest is done one by one. What is sampled becomes valid; wi, pdf and pLight of other lanes
///       stay.
template <typename T>
concept WideLight = requires(const LightsOf<T> &lights, const LightSampleContextX16 &ctx,
                             const Point2fX16 &u, const WavelengthPacket &lambda, LaneBits lanes,
                             LightLiSamples *samples) {
    { T::SampleLi(lights, ctx, u, lambda, lanes, samples) } -> std::same_as<LaneBits>;
};

/// A light with isWideSeen.
///   void Le(const Vector3fX16 &d, const WavelengthPacket &, LaneBits lanes, LightLePacket *) const
///       Le and PDF_Li in the given lanes; what it leaves in the others does not matter.
template <typename T>
concept WideInfiniteLight = requires(const T l, const Vector3fX16 &d,
                                     const WavelengthPacket &lambda, LaneBits lanes,
                                     LightLePacket *le) {
    { l.Le(d, lambda, lanes, le) } -> std::same_as<void>;
};

template <typename T>
concept ReadsSceneRadius = requires(T l, float radius) {
    { l.Preprocess(radius) } -> std::same_as<void>;
};

/// The whole contract: BasicLight, what the traits announce, and nothing that they do not.
template <typename T>
concept LightType =
    BasicLight<T> && T::kTraits.isArea + T::kTraits.isInfinite + T::kTraits.isDelta <= 1 &&
    detail::AsAnnounced<T::kTraits.isArea, AreaLightType<T>> &&detail::AsAnnounced<
        T::kTraits.isInfinite && !T::kTraits.dependsOnPlace, InfiniteLightType<T>>
        &&detail::AsAnnounced<T::kTraits.dependsOnPlace, PlacedInfiniteLight<T>>
            &&detail::AsAnnounced<T::kTraits.readsSceneRadius, ReadsSceneRadius<T>>
                &&detail::AsAnnounced<T::kTraits.isWide, WideLight<T>>
                    &&detail::AsAnnounced<T::kTraits.isWideSeen, WideInfiniteLight<T>>;

/// LightType<T>, or an error that names T and the member that is missing or not announced.
template <BasicLight T>
struct LightContract {
    static constexpr bool value = [] {
        if constexpr (T::kTraits.isArea) static_assert(AreaLightType<T>);
        if constexpr (T::kTraits.dependsOnPlace)
            static_assert(T::kTraits.isInfinite && PlacedInfiniteLight<T>);
        else if constexpr (T::kTraits.isInfinite)
            static_assert(InfiniteLightType<T>);
        if constexpr (T::kTraits.readsSceneRadius) static_assert(ReadsSceneRadius<T>);
        if constexpr (T::kTraits.isWide) static_assert(WideLight<T>);
        if constexpr (T::kTraits.isWideSeen) static_assert(WideInfiniteLight<T>);
        return LightType<T>;
    }();
};

}  // namespace pbrt
