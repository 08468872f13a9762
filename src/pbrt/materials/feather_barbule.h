#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/feather_barbule_packet.h"
#include "pbrt/feather/params.h"
#include "pbrt/materials/bounded_texture.h"

namespace pbrt {

/// The vane of an iridescent feather (MODEL section 2). Parameters, ranges and defaults are those
/// of feather::kParams and feather::kSpectrumParams. Constants are checked when the scene is read;
/// texture values out of range are clamped and counted.
class FeatherBarbuleMaterial {
  public:
    static constexpr std::string_view kName = "featherbarbule";
    static constexpr MaterialTraits kTraits{.canBeUniform = true,
                                            .turnsFrame = true,
                                            .nullTransmission = true,
                                            .laidByUV = true,
                                            .warns = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        "", "\"float thickness\" 400 \"float rotation\" 30"};

    static FeatherBarbuleMaterial Create(ParamDict &params, const NamedTextures &named);

    bool IsUniform() const;
    static constexpr std::string_view LaidByUV() { return "barbules"; }
    FeatherBarbuleBxDF GetBxDF(const TextureEvalContext &ctx,
                               const SampledWavelengths &lambda) const {
        return FeatherBarbuleBxDF(GetPacketInput(ctx, lambda));
    }
    FeatherSurface GetPacketInput(const TextureEvalContext &ctx,
                                  const SampledWavelengths &lambda) const;
    /// True unless `rotation` is 0 everywhere.
    bool TurnsFrame() const {
        return !values[Rotation].IsConstant() || values[Rotation].Constant() != 0;
    }
    /// The shading frame, turned about its normal by `rotation`.
    Frame TurnFrame(const Frame &frame, const TextureEvalContext &ctx) const;
    /// Share of light from direction w (local, of the turned frame) that passes straight through.
    float NullTransmission(const TextureEvalContext &ctx, Vector3f w) const;
    /// The model itself at these wavelengths (nm), in any scalar and with any quadrature: what
    /// tests and tools judge GetBxDF by. `Model` is a feather::Barbule of N wavelengths.
    template <typename Model, std::size_t N>
    Model ModelAt(const TextureEvalContext &ctx, const std::array<float, N> &nanometres) const;
    /// A sentence where texture values had to be clamped; else empty.
    std::string Warnings(const ClampCounts &counts) const;

  private:
    enum { Thickness, Spacing, Tilt, Aspect, Opening, Rotation };
    using Vane = feather::Vane<float>;
    template <typename T>
    feather::Vane<T> MakeVane(const TextureEvalContext &ctx) const;
    bool IsConstant(std::initializer_list<int> which) const;
    /// constantVane, or `room` with the vane there.
    const Vane &VaneAt(const TextureEvalContext &ctx, std::optional<Vane> *room) const;

    std::array<BoundedTexture, feather::kParams.size()> values;
    std::optional<Vane> constantVane;  ///< if its shape is the same everywhere
    Spectrum eta;
    SpectrumTexture melanin;
};
static_assert(MaterialType<FeatherBarbuleMaterial>);

template <typename T>
feather::Vane<T> FeatherBarbuleMaterial::MakeVane(const TextureEvalContext &ctx) const {
    return feather::Vane<T>({.spacing = values[Spacing].Evaluate(ctx),
                             .tilt = {values[Tilt].Evaluate(ctx)},
                             .aspect = values[Aspect].Evaluate(ctx),
                             .opening = {values[Opening].Evaluate(ctx)}});
}

template <typename Model, std::size_t N>
Model FeatherBarbuleMaterial::ModelAt(const TextureEvalContext &ctx,
                                      const std::array<float, N> &nanometres) const {
    using T = typename Model::Spectrum::value_type;
    feather::Optics<T, int(N)> optics;
    for (std::size_t i = 0; i < N; ++i) {
        const float lambda = nanometres[i];
        const auto alone = SampledWavelengths::Of({lambda, lambda, lambda, lambda});
        optics.lambda[i] = lambda;
        optics.eta[i] = std::max(1.f, eta(lambda));
        optics.melanin[i] = std::clamp(melanin.Evaluate(ctx, alone)[0], 0.f, 1.f);
    }
    return Model(MakeVane<T>(ctx), {values[Thickness].Evaluate(ctx)}, optics);
}

}  // namespace pbrt
