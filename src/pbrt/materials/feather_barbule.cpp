#include "pbrt/materials/feather_barbule.h"

#include <fmt/format.h>

#include <algorithm>

namespace pbrt {
namespace {

/// The model's table as rows of the scene language.
constexpr FloatParam RowOf(const feather::FloatParam &p) {
    return {p.name, feather::UnitName(p.unit), float(p.def), float(p.lo), float(p.hi), p.doc};
}
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
    if (m.IsConstant({Spacing, Tilt, Aspect, Opening})) m.constantVane = m.MakeVane<float>({});
    return m;
}

bool FeatherBarbuleMaterial::IsConstant(std::initializer_list<int> which) const {
    return std::all_of(which.begin(), which.end(),
                       [&](int i) { return values[size_t(i)].IsConstant(); });
}

bool FeatherBarbuleMaterial::IsUniform() const {
    return constantVane && IsConstant({Thickness, Rotation}) && melanin.IsConstant();
}

const FeatherBarbuleMaterial::Vane &FeatherBarbuleMaterial::VaneAt(
    const TextureEvalContext &ctx, std::optional<Vane> *room) const {
    return constantVane ? *constantVane : room->emplace(MakeVane<float>(ctx));
}

FeatherSurface FeatherBarbuleMaterial::GetPacketInput(const TextureEvalContext &ctx,
                                                      const SampledWavelengths &lambda) const {
    std::optional<Vane> room;
    FeatherSurface surface{VaneAt(ctx, &room), values[Thickness].Evaluate(ctx), {}};
    const SampledSpectrum etas = eta.Sample(lambda), reflectance = melanin.Evaluate(ctx, lambda);
    for (int i = 0; i < NSpectrumSamples; ++i) {
        surface.optics.lambda[i] = lambda[i];
        surface.optics.eta[i] = std::max(1.f, etas[i]);
        surface.optics.melanin[i] = std::clamp(reflectance[i], 0.f, 1.f);
    }
    return surface;
}

Frame FeatherBarbuleMaterial::TurnFrame(const Frame &frame, const TextureEvalContext &ctx) const {
    const float degrees = values[Rotation].Evaluate(ctx);
    if (degrees == 0) return frame;
    const float c = std::cos(Radians(degrees)), s = std::sin(Radians(degrees));
    return {c * frame.x + s * frame.y, c * frame.y - s * frame.x, frame.z};
}

float FeatherBarbuleMaterial::NullTransmission(const TextureEvalContext &ctx, Vector3f w) const {
    std::optional<Vane> room;
    return VaneAt(ctx, &room).GapFraction({w.x, w.y, w.z});
}

std::string FeatherBarbuleMaterial::Warnings(const ClampCounts &counts) const {
    std::string text;
    for (const BoundedTexture &texture : values)
        texture.AddWarning(kName, counts, &text);
    return text;
}

}  // namespace pbrt
