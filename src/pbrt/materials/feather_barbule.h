#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>

#include "pbrt/bxdfs/feather_barbule.h"
#include "pbrt/feather/params.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// The vane of an iridescent feather (MODEL section 2). Parameters, ranges and defaults are those of
/// feather::kParams and feather::kSpectrumParams. Constants are checked when the scene is read;
/// texture values out of range are clamped and counted.
class FeatherBarbuleMaterial {
  public:
    static constexpr std::string_view kName = "featherbarbule";
    static constexpr bool kPassesLight = true;

    static FeatherBarbuleMaterial Create(ParamDict &params, const NamedTextures &named);

    FeatherBarbuleBxDF GetBxDF(const TextureEvalContext &ctx,
                               const SampledWavelengths &lambda) const;
    /// The shading frame, turned about its normal by `rotation`.
    Frame TurnFrame(const Frame &frame, const TextureEvalContext &ctx) const;
    /// Share of light from direction w (local, of the turned frame) that passes straight through.
    float GapFraction(const TextureEvalContext &ctx, Vector3f w) const;
    /// The double-precision twin of GetBxDF's model at these wavelengths (nm): the oracle of tests
    /// and tools. `Quadrature` as in feather::Barbule.
    template <typename Model>
    Model Oracle(const TextureEvalContext &ctx,
                 const std::array<float, NSpectrumSamples> &nanometres) const;
    /// A sentence where texture values had to be clamped; else empty.
    std::string Remarks() const;

  private:
    enum { Thickness, Spacing, Tilt, Aspect, Opening, Rotation };
    float Value(int parameter, const TextureEvalContext &ctx) const;
    feather::BarbuleParams<float> Params(const TextureEvalContext &ctx) const;

    std::array<FloatTexture, feather::kParams.size()> values;
    Spectrum eta;
    SpectrumTexture melanin;
    bool constantShape = false;  ///< spacing, tilt, aspect and opening are constants
    struct ClampCounts {
        std::array<std::atomic<int64_t>, feather::kParams.size()> counts{};
    };
    std::shared_ptr<ClampCounts> clamped = std::make_shared<ClampCounts>();
};

template <typename Model>
Model FeatherBarbuleMaterial::Oracle(
    const TextureEvalContext &ctx, const std::array<float, NSpectrumSamples> &nanometres) const {
    const feather::BarbuleParams<float> p = Params(ctx);
    feather::Optics<double, NSpectrumSamples> optics;
    const SampledSpectrum reflectance =
        melanin.Evaluate(ctx, SampledWavelengths::Of(nanometres));
    for (int i = 0; i < NSpectrumSamples; ++i) {
        optics.lambda[i] = nanometres[i];
        optics.eta[i] = std::max(1.f, eta(nanometres[i]));
        optics.melanin[i] = std::clamp(reflectance[i], 0.f, 1.f);
    }
    return Model({{p.thickness.value}, p.spacing, {p.tilt.value}, p.aspect, {p.opening.value}},
                 optics);
}

}  // namespace pbrt
