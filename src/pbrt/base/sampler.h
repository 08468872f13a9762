#pragma once

#include <concepts>
#include <optional>
#include <span>

#include "pbrt/base/plug_in.h"
#include "pbrt/util/vecmath.h"
#include "pbrt/util/vecmath_simd.h"

// The contract of a sampler: the random numbers of a path. The closed list of samplers is in
// pbrt/samplers/samplers.h.

namespace pbrt {

class ParamDict;

/// The draw that is the place in the pixel: samplers that lay one sequence over the whole image
/// give it the dimensions by which they count the pixels (the camera's draws: camera_sample.h).
inline constexpr int kFilmDimension = 1;

/// Arguments of a sampler besides its own parameters.
struct SamplerContext {
    std::optional<int> spp;  ///< from the command line, > 0; comes before the file's
    int seed = 0;            ///< where the file gives none
    Point2i fullResolution;  ///< of the whole image, pixels
};

/// Members that a sampler may have beyond the compulsory ones.
struct SamplerTraits {
    /// Has, for many samples side by side, pixels of a batch by their place in the span:
    ///     void StartBatch(std::span<const Point2i> pixels)
    ///     FloatX16 Get1D(int dimension, UintX16 pixel, UintX16 index)
    ///     Point2fX16 Get2D(int dimension, UintX16 pixel, UintX16 index)
    /// Lane by lane they give exactly what StartPixelSample(pixels[pixel], index, dimension) and
    /// Get1D or Get2D give. In lanes whose numbers nobody wants pixel lies in the span all the
    /// same; index may be anything. A batch holds until the next StartBatch, which alone reads the
    /// span. What depends on the pixels may be kept in the sampler. Without it the path integrator
    /// draws the sixteen one by one (samplers/batch_sampler.h).
    bool hasBatches = false;
};

namespace detail {
template <typename S>
concept HasBatches = requires(S s, std::span<const Point2i> pixels, int dimension, UintX16 lanes) {
    s.StartBatch(pixels);
    { s.Get1D(dimension, lanes, lanes) } -> std::same_as<FloatX16>;
    { s.Get2D(dimension, lanes, lanes) } -> std::same_as<Point2fX16>;
};
}  // namespace detail

/// A small copyable class; each thread has a copy of its own.
///
///   kTraits                  SamplerTraits
///   Create(params, context)  reads all parameters; mistakes are reported through params, and the
///                            sampler is usable all the same
///   SamplesPerPixel()        >= 1
///   StartPixelSample(pixel, index, dimension)   the next draws are those of this sample,
///                            0 <= index < SamplesPerPixel(), from this draw on; `dimension`, 0
///                            where not given, counts draws of either kind
///   Get1D()                  the next draw, in [0, 1)
///   Get2D()                  the next draw, in [0, 1)^2
///
/// kExamples give no seed and take all randomness that there is. The same seed, pixel, index and
/// dimension give the same numbers, in any order. Each draw is uniform over the samples of all
/// pixels, and so are pairs of draws.
template <typename S>
concept SamplerType = PlugInType<S> && std::copyable<S> &&
    requires(S s, const S fixed, ParamDict &params, const SamplerContext &context, Point2i pixel) {
    { S::kTraits } -> std::same_as<const SamplerTraits &>;
    { S::Create(params, context) } -> std::same_as<S>;
    { fixed.SamplesPerPixel() } -> std::same_as<int>;
    s.StartPixelSample(pixel, 0);
    s.StartPixelSample(pixel, 0, 0);
    { s.Get1D() } -> std::same_as<float>;
    { s.Get2D() } -> std::same_as<Point2f>;
} && detail::AsAnnounced<S::kTraits.hasBatches, detail::HasBatches<S>>;

}  // namespace pbrt
