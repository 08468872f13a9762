#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

enum class TransportMode : uint8_t { Radiance, Importance };

enum class BxDFReflTransFlags : uint8_t { Unset = 0, Reflection = 1, Transmission = 2, All = 3 };

enum class BxDFFlags : uint8_t {
    Unset = 0,
    Reflection = 1,
    Transmission = 2,
    Diffuse = 4,
    Glossy = 8,
    Specular = 16,
    /// Straight through (wi = -wo): no refraction, no bounce; the path keeps its MIS state.
    NullTransmission = 32,
};
constexpr BxDFFlags operator|(BxDFFlags a, BxDFFlags b) {
    return BxDFFlags(uint8_t(a) | uint8_t(b));
}
constexpr bool Has(BxDFFlags flags, BxDFFlags bits) {
    return (uint8_t(flags) & uint8_t(bits)) != 0;
}
constexpr bool IsReflective(BxDFFlags f) {
    return Has(f, BxDFFlags::Reflection);
}
constexpr bool IsTransmissive(BxDFFlags f) {
    return Has(f, BxDFFlags::Transmission);
}
constexpr bool IsSpecular(BxDFFlags f) {
    return Has(f, BxDFFlags::Specular);
}
constexpr bool IsNonSpecular(BxDFFlags f) {
    return Has(f, BxDFFlags::Diffuse | BxDFFlags::Glossy);
}

struct BSDFSample {
    SampledSpectrum f;  ///< 1/sr without cosine; for delta lobes F/|cos|
    Vector3f wi;
    float pdf;  ///< 1/sr; for delta lobes the lobe's probability
    BxDFFlags flags;
    float eta = 1;  ///< relative index of refraction where the sample refracts
};

/// f and PDF for the same directions.
struct BSDFEval {
    SampledSpectrum f;
    float pdf;
};

/// A BxDF lives in the local frame (z the shading normal, x along dp/du); directions are unit and
/// point away from the surface. f excludes the cosine; f and PDF are functions: no randomness.
/// Both are 0 for delta lobes. A BxDF may also have
///   void Regularize()  blurs lobes sharper than alpha 0.3 (TrowbridgeReitz), for the integrator's
///                      "regularize"; default: nothing here is so sharp
///   BSDFEval Evaluate(Vector3f wo, Vector3f wi, TransportMode) const
///                      f and PDF together; default: one after the other. For those that share
///                      much of their work.
template <typename B>
concept BxDFModel = requires(const B b, Vector3f w, float u, Point2f u2, TransportMode mode) {
    { b.Flags() } -> std::same_as<BxDFFlags>;
    { b.f(w, w, mode) } -> std::same_as<SampledSpectrum>;
    { b.PDF(w, w, mode) } -> std::same_as<float>;
    { b.Sample_f(w, u, u2, mode) } -> std::same_as<std::optional<BSDFSample>>;
};

/// Blurs what is sharp, if B is ever so.
template <BxDFModel B>
void Regularize(B &bxdf) {
    if constexpr (requires { bxdf.Regularize(); }) bxdf.Regularize();
}

}  // namespace pbrt
