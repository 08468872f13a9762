#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/feather_barbule_packet.h"
#include "pbrt/feather/params.h"
#include "pbrt/materials/bounded_texture.h"
#include "pbrt/materials/feather_cells.h"

namespace pbrt {

/// The vane of an iridescent feather (MODEL sections 2 and 11). Parameters, ranges and defaults are
/// those of feather::kParams, kSpectrumParams and kCellParams. Constants are checked when the scene
/// is read; texture values out of range are clamped and counted.
///
/// With cells, film, tilt and frame are those of the point's cell. Whoever asks finds the same one.
class FeatherBarbuleMaterial {
  public:
    static constexpr std::string_view kName = "featherbarbule";
    static constexpr MaterialTraits kTraits{.canBeUniform = true,
                                            .turnsFrame = true,
                                            .nullTransmission = true,
                                            .laidByUV = true,
                                            .warns = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"float thickness\" 400 \"float rotation\" 30",
        "\"float spacing\" 2.5 \"float filmroughness\" 20 \"float cellthickness\" 10 "
        "\"float celltilt\" 0.05 \"float cellbend\" 0.03 \"float cellsacross\" 30 "
        "\"float cellsalong\" 7 \"float cellshear\" 0.1 \"bool cellsperface\" true "
        "\"integer cellseed\" 3"};

    static FeatherBarbuleMaterial Create(ParamDict &params, const NamedTextures &named);

    bool IsUniform() const;
    static constexpr std::string_view LaidByUV() { return "barbules"; }
    FeatherBarbuleBxDF GetBxDF(const TextureEvalContext &ctx,
                               const SampledWavelengths &lambda) const {
        return FeatherBarbuleBxDF(GetPacketInput(ctx, lambda));
    }
    FeatherSurface GetPacketInput(const TextureEvalContext &ctx,
                                  const SampledWavelengths &lambda) const;
    /// True unless `rotation` is 0 everywhere, and `cellbend`.
    bool TurnsFrame() const { return Varies(Rotation) || Varies(CellBend); }
    /// The shading frame, turned about its normal by `rotation` and then about its x axis by the
    /// cell's bend.
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
    /// Places in feather::kParams.
    enum {
        Thickness,
        Spacing,
        Tilt,
        Aspect,
        Opening,
        Rotation,
        FilmRoughness,
        CellThickness,
        CellTilt,
        CellBend
    };
    using Vane = feather::Vane<float>;
    template <typename T>
    feather::Vane<T> MakeVane(const TextureEvalContext &ctx, const FeatherCell &cell) const;
    bool IsConstant(std::initializer_list<int> which) const;
    /// Not 0 everywhere.
    bool Varies(int i) const {
        return !values[size_t(i)].IsConstant() || values[size_t(i)].Constant() != 0;
    }
    void CheckCells(ParamDict &params) const;
    FeatherCell CellAt(const TextureEvalContext &ctx) const;
    float ThicknessAt(const TextureEvalContext &ctx, const FeatherCell &cell) const;
    float TiltAt(const TextureEvalContext &ctx, const FeatherCell &cell) const;
    /// The vane there, and the tilt of its barbules if that is another.
    struct TiltableVane {
        Vane vane;
        std::optional<float> tilt;
    };
    TiltableVane VaneAt(const TextureEvalContext &ctx, const FeatherCell &cell) const;

    std::array<BoundedTexture, feather::kParams.size()> values;
    FeatherCells cells;
    std::optional<Vane> evenVane;  ///< of no cell, if its shape is the same everywhere
    Spectrum eta;
    SpectrumTexture melanin;
};
static_assert(MaterialType<FeatherBarbuleMaterial>);

template <typename T>
feather::Vane<T> FeatherBarbuleMaterial::MakeVane(const TextureEvalContext &ctx,
                                                  const FeatherCell &cell) const {
    return feather::Vane<T>({.spacing = values[Spacing].Evaluate(ctx),
                             .tilt = {TiltAt(ctx, cell)},
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
    const FeatherCell cell = CellAt(ctx);
    return Model(MakeVane<T>(ctx, cell), {ThicknessAt(ctx, cell)}, optics,
                 {values[FilmRoughness].Evaluate(ctx)});
}

}  // namespace pbrt
