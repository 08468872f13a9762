#include "pbrt/materials/feather_barbule.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "pbrt/materials/feather_rows.h"

namespace pbrt {
namespace {

constexpr SpectrumParam RowOf(const feather::SpectrumParam &p, SpectrumType role) {
    return {p.name, role, p.def, p.doc, float(p.lo), float(p.hi)};
}
constexpr SpectrumParam kEta = RowOf(feather::kSpectrumParams[0], SpectrumType::Unbounded);
constexpr SpectrumParam kMelanin = RowOf(feather::kSpectrumParams[1], SpectrumType::Albedo);

/// A guess at the mistake that led to v outside [lo, hi].
std::string_view Guess(const SpectrumParam &row, float v) {
    if (v == 0) return "; spectra that stand in the scene are 0 outside their wavelengths";
    const bool looksLikePercent = row.hi == 1 && v > 1 && v <= 100;
    return looksLikePercent ? "; is this in percent?" : "";
}

/// Reports the first whole nanometre at which `s` leaves [lo, hi].
void CheckRange(ParamDict &params, const SpectrumParam &row, const Spectrum &s) {
    for (int lambda = int(LambdaMin); lambda <= int(LambdaMax); ++lambda) {
        const float v = s(float(lambda));
        if (v >= row.lo && v <= row.hi) continue;
        params.Error(row.name, fmt::format("\"{}\" is {} at {} nm, outside [{}, {}]{}", row.name, v,
                                           lambda, row.lo, row.hi, Guess(row, v)));
        return;
    }
}

Frame Rotated(const Frame &frame, float degrees) {
    if (degrees == 0) return frame;
    const float c = std::cos(Radians(degrees)), s = std::sin(Radians(degrees));
    return {c * frame.x + s * frame.y, c * frame.y - s * frame.x, frame.z};
}
Frame Bent(const Frame &frame, float angle) {
    const auto [s, c] = SinCosTurns(angle * (0.5f * InvPi));
    return {frame.x, c * frame.y - s * frame.z, s * frame.y + c * frame.z};
}

}  // namespace

FeatherBarbuleMaterial FeatherBarbuleMaterial::Create(ParamDict &params,
                                                      const NamedTextures &named) {
    FeatherBarbuleMaterial m;
    for (size_t i = 0; i < feather::kParams.size(); ++i)
        m.values[i] = {params, named, RowOf(feather::kParams[i])};
    m.eta = params.GetOneSpectrum(kEta).value_or(DefaultSpectrum(kEta));
    CheckRange(params, kEta, m.eta);
    m.melanin = GetSpectrumTexture(params, named, kMelanin);
    if (m.melanin.IsConstant()) CheckRange(params, kMelanin, m.melanin.Constant());
    if (m.IsConstant({Spacing, Tilt, Aspect, Opening})) m.evenVane = m.MakeVane<float>({}, {});
    m.cells = FeatherCells::Create(params);
    m.CheckCells(params);
    return m;
}

void FeatherBarbuleMaterial::CheckCells(ParamDict &params) const {
    if (cells) return;
    for (const int i : {CellThickness, CellTilt, CellBend}) {
        if (!Varies(i)) continue;
        const std::string_view name = feather::kParams[size_t(i)].name;
        params.Error(name, fmt::format("\"{}\" is how cells differ, and there are none: give "
                                       "\"cellsacross\" and \"cellsalong\", the number of cells "
                                       "for one unit of u and of v",
                                       name));
        return;
    }
}

bool FeatherBarbuleMaterial::IsConstant(std::initializer_list<int> which) const {
    return std::all_of(which.begin(), which.end(),
                       [&](int i) { return values[size_t(i)].IsConstant(); });
}

bool FeatherBarbuleMaterial::IsUniform() const {
    return evenVane && IsConstant({Thickness, FilmRoughness, Rotation}) && melanin.IsConstant() &&
           !cells;
}

FeatherCell FeatherBarbuleMaterial::CellAt(const TextureEvalContext &ctx) const {
    return cells ? cells.At(ctx) : FeatherCell{};
}

float FeatherBarbuleMaterial::ThicknessAt(const TextureEvalContext &ctx,
                                          const FeatherCell &cell) const {
    const float mean = values[Thickness].Evaluate(ctx);
    return cells ? std::max(0.f, mean + values[CellThickness].Evaluate(ctx) * cell.thickness)
                 : mean;
}

float FeatherBarbuleMaterial::TiltAt(const TextureEvalContext &ctx, const FeatherCell &cell) const {
    constexpr float upright = std::numbers::pi_v<float> / 2;
    const float mean = values[Tilt].Evaluate(ctx);
    return cells ? std::clamp(mean + values[CellTilt].Evaluate(ctx) * cell.tilt, -upright, upright)
                 : mean;
}

FeatherBarbuleMaterial::TiltableVane FeatherBarbuleMaterial::VaneAt(const TextureEvalContext &ctx,
                                                                    const FeatherCell &cell) const {
    if (!evenVane) return {MakeVane<float>(ctx, cell), {}};
    if (!cells || !Varies(CellTilt)) return {*evenVane, {}};
    return {*evenVane, TiltAt(ctx, cell)};
}

FeatherSurface FeatherBarbuleMaterial::GetPacketInput(const TextureEvalContext &ctx,
                                                      const SampledWavelengths &lambda) const {
    const FeatherCell cell = CellAt(ctx);
    const auto [vane, tilt] = VaneAt(ctx, cell);
    FeatherSurface surface{
        vane, tilt, ThicknessAt(ctx, cell), values[FilmRoughness].Evaluate(ctx), {}};
    const SampledSpectrum etas = eta.Sample(lambda), reflectance = melanin.Evaluate(ctx, lambda);
    for (int i = 0; i < NSpectrumSamples; ++i) {
        surface.optics.lambda[i] = lambda[i];
        surface.optics.eta[i] = std::max(1.f, etas[i]);
        surface.optics.melanin[i] = std::clamp(reflectance[i], 0.f, 1.f);
    }
    return surface;
}

Frame FeatherBarbuleMaterial::TurnFrame(const Frame &frame, const TextureEvalContext &ctx) const {
    const Frame rotated = Rotated(frame, values[Rotation].Evaluate(ctx));
    if (!cells || !Varies(CellBend)) return rotated;
    return Bent(rotated, values[CellBend].Evaluate(ctx) * cells.At(ctx).bend);
}

float FeatherBarbuleMaterial::NullTransmission(const TextureEvalContext &ctx, Vector3f w) const {
    auto [vane, tilt] = VaneAt(ctx, CellAt(ctx));
    if (tilt) vane.row.Tilt(true, {*tilt});
    return vane.GapFraction({w.x, w.y, w.z});
}

std::string FeatherBarbuleMaterial::Warnings(const ClampCounts &counts) const {
    std::string text;
    for (const BoundedTexture &texture : values)
        texture.AddWarning(kName, counts, &text);
    return text;
}

}  // namespace pbrt
