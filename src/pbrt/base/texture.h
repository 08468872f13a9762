#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <optional>

#include <cstdint>
#include <utility>
#include <vector>
#include "pbrt/base/plug_in.h"
#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/vecmath.h"
#include "pbrt/util/vecmath_simd.h"

// The contract of a texture: a number or a spectrum that varies over surfaces. The closed list of
// them is in pbrt/textures/textures.h; what materials hold are the handles FloatTexture and
// SpectrumTexture below.

namespace pbrt {

/// Steps of a surface point and of its uv per pixel; 0 where no filtering is wanted.
template <typename T>
struct TextureFootprint {
    Vec3<T> dpdx, dpdy;
    T dudx{}, dudy{}, dvdx{}, dvdy{};
};
inline TextureFootprint<float> Lane(const TextureFootprint<FloatX16> &f, int i) {
    return {Lane(f.dpdx, i), Lane(f.dpdy, i), f.dudx[i], f.dudy[i], f.dvdx[i], f.dvdy[i]};
}

/// Counts of values that had to be clamped to their ranges, by owner; one object for each thread.
class ClampCounts {
  public:
    void Add(const void *whose, int64_t n = 1) {
        for (auto &[known, count] : counts)
            if (known == whose) return void(count += n);
        counts.emplace_back(whose, n);
    }
    int64_t Of(const void *whose) const {
        for (const auto &[known, count] : counts)
            if (known == whose) return count;
        return 0;
    }
    ClampCounts &operator+=(const ClampCounts &b) {
        for (const auto &[whose, count] : b.counts)
            Add(whose, count);
        return *this;
    }

  private:
    std::vector<std::pair<const void *, int64_t>> counts;  ///< few, most often none
};

/// Point at which a texture is looked up. `p` in rendering space.
struct TextureEvalContext : TextureFootprint<float> {
    Point3f p;
    Normal3f n;
    Point2f uv;
    int faceIndex = 0;               ///< the mesh's face index, else the number of the primitive
    ClampCounts *clamped = nullptr;  ///< counts values out of range, unless null
};

/// A texture that is more than a constant; immutable.
class FloatNode {
  public:
    virtual ~FloatNode() = default;
    virtual float Evaluate(const TextureEvalContext &ctx) const = 0;
};
class SpectrumNode {
  public:
    virtual ~SpectrumNode() = default;
    virtual SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                                     const SampledWavelengths &lambda) const = 0;
};

/// A constant, or a node. Constants cost no call.
class FloatTexture {
  public:
    FloatTexture() = default;
    FloatTexture(float value) : value(value) {}
    FloatTexture(std::shared_ptr<const FloatNode> node) : node(std::move(node)) {}
    bool IsConstant() const { return !node; }
    /// Only where IsConstant().
    float Constant() const { return value; }
    float Evaluate(const TextureEvalContext &ctx) const {
        return node ? node->Evaluate(ctx) : value;
    }

  private:
    float value = 0;
    std::shared_ptr<const FloatNode> node;
};

class SpectrumTexture {
  public:
    SpectrumTexture() = default;
    SpectrumTexture(Spectrum value) : value(std::move(value)) {}
    SpectrumTexture(std::shared_ptr<const SpectrumNode> node) : node(std::move(node)) {}
    bool IsConstant() const { return !node; }
    const Spectrum &Constant() const { return value; }
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const {
        return node ? node->Evaluate(ctx, lambda) : value.Sample(lambda);
    }

  private:
    Spectrum value;
    std::shared_ptr<const SpectrumNode> node;
};

/// One spectrum texture in its roles, indexed by SpectrumType. Empty where RGB values above 1
/// forbid the role of albedo.
using SpectrumByRole = std::array<std::optional<SpectrumTexture>, 3>;
/// Source of a texture type's parameters; in pbrt/textures/texture_builder.h.
struct TextureBuilder;

template <typename T>
concept FloatOnlyTexture = requires {
    requires T::kIsFloatOnly;
};
template <typename T>
concept SpectrumTextureType = requires(TextureBuilder &builder) {
    { T::CreateSpectrum(builder) } -> std::same_as<SpectrumByRole>;
};

/// A texture type makes FloatTextures and SpectrumTextures of the parameters of a directive
/// `Texture "name" "float" "<kName>" ...` or `Texture "name" "spectrum" "<kName>" ...`. It is never
/// made itself: its nodes, if any, are of types of its own, and immutable.
///
///   CreateFloat(builder)     the texture of a float. After an error, which is reported through
///                            builder.params, any texture
///   CreateSpectrum(builder)  the same of a spectrum, in each role that it can have: values of an
///                            albedo lie in [0, 1], of the others are >= 0, unless float textures
///                            scale or mix them beyond; materials clamp what they use
///   static constexpr bool kIsFloatOnly = true
///                            instead of CreateSpectrum: a spectrum of that name is an error
///
/// kExamples serve floats and spectra alike; files that they name are example.exr and example.ptx,
/// which the tests write. Either function fills in what the builder has for it: builder.readsUV
/// where the surface's uv are looked at (else meshes without uv get no warning),
/// builder.named.readFootprints where the steps per pixel are (else they may be 0: a scene none of
/// whose textures reads them does not work them out).
template <typename T>
concept TextureType = PlugInType<T> && requires(TextureBuilder &builder) {
    { T::CreateFloat(builder) } -> std::convertible_to<FloatTexture>;
} &&(FloatOnlyTexture<T> != SpectrumTextureType<T>);

}  // namespace pbrt
