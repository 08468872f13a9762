#include "pbrt/materials/feather_barbule.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

NumberRow Row(const feather::Param &p) {
    return {p.name, feather::UnitName(p.unit), float(p.def), float(p.lo), float(p.hi), p.doc};
}

/// Reports the first whole nanometre at which `s` leaves [lo, hi].
void CheckRange(ParamDict &params, const feather::SpectrumParam &row, const Spectrum &s) {
    for (int lambda = int(LambdaMin); lambda <= int(LambdaMax); ++lambda) {
        const float v = s(float(lambda));
        if (v >= float(row.lo) && v <= float(row.hi)) continue;
        params.Error(row.name, fmt::format("\"{}\" is {} at {} nm, outside [{}, {}]", row.name, v,
                                           lambda, row.lo, row.hi));
        return;
    }
}

}  // namespace

FeatherBarbuleMaterial FeatherBarbuleMaterial::Create(ParamDict &params,
                                                      const NamedTextures &named) {
    FeatherBarbuleMaterial m;
    for (size_t i = 0; i < feather::kParams.size(); ++i)
        m.values[i] = GetFloatTexture(params, named, Row(feather::kParams[i]));
    const feather::SpectrumParam &eta = feather::kSpectrumParams[0];
    const feather::SpectrumParam &melanin = feather::kSpectrumParams[1];
    m.eta = params.GetOneSpectrum(eta.name, SpectrumType::Unbounded)
                .value_or(*GetNamedSpectrum(eta.def));
    CheckRange(params, eta, m.eta);
    m.melanin = GetSpectrumTexture(params, named, melanin.name, *GetNamedSpectrum(melanin.def),
                                   SpectrumType::Albedo);
    if (m.melanin.IsConstant()) CheckRange(params, melanin, m.melanin.Constant());
    return m;
}

float FeatherBarbuleMaterial::Value(int parameter, const TextureEvalContext &ctx) const {
    const FloatTexture &texture = values[parameter];
    if (texture.IsConstant()) return texture.Constant();
    const feather::Param &row = feather::kParams[parameter];
    const float v = texture.Evaluate(ctx);
    const float legal = std::clamp(v, float(row.lo), float(row.hi));
    if (v == legal) return v;
    clamped->counts[parameter].fetch_add(1, std::memory_order_relaxed);
    // A texture that is not a number there counts as the default.
    return legal == legal ? legal : float(row.def);
}

feather::BarbuleParams<float> FeatherBarbuleMaterial::Params(const TextureEvalContext &ctx) const {
    return {{Value(Thickness, ctx)},
            Value(Spacing, ctx),
            {Value(Tilt, ctx)},
            Value(Aspect, ctx),
            {Value(Opening, ctx)}};
}

FeatherBarbuleBxDF FeatherBarbuleMaterial::GetBxDF(const TextureEvalContext &ctx,
                                                   const SampledWavelengths &lambda) const {
    feather::Optics<float, NSpectrumSamples> optics;
    const SampledSpectrum etas = eta.Sample(lambda), reflectance = melanin.Evaluate(ctx, lambda);
    for (int i = 0; i < NSpectrumSamples; ++i) {
        optics.lambda[i] = lambda[i];
        optics.eta[i] = std::max(1.f, etas[i]);
        optics.melanin[i] = std::clamp(reflectance[i], 0.f, 1.f);
    }
    return FeatherBarbuleBxDF(FeatherBarbuleBxDF::Model(Params(ctx), optics));
}

Frame FeatherBarbuleMaterial::TurnFrame(const Frame &frame, const TextureEvalContext &ctx) const {
    const float degrees = Value(Rotation, ctx);
    if (degrees == 0) return frame;
    const float c = std::cos(Radians(degrees)), s = std::sin(Radians(degrees));
    return {c * frame.x + s * frame.y, c * frame.y - s * frame.x, frame.z};
}

float FeatherBarbuleMaterial::GapFraction(const TextureEvalContext &ctx, Vector3f w) const {
    const feather::BarbuleParams<float> p = Params(ctx);
    const feather::Row<float> row(p.spacing, p.tilt, p.aspect);
    const feather::Bend<float> bend(p.opening);
    if (std::abs(w.z) < FeatherBarbuleBxDF::Model::kGrazing) return 0;
    return feather::GapFraction(row, bend, feather::Direction<float>{w.x, w.y, w.z});
}

std::string FeatherBarbuleMaterial::Remarks() const {
    std::string text;
    for (size_t i = 0; i < feather::kParams.size(); ++i) {
        const int64_t n = clamped->counts[i].load();
        if (n == 0) continue;
        const feather::Param &row = feather::kParams[i];
        text += fmt::format("{}featherbarbule \"{}\": {} texture values outside [{}, {}] {} clamped",
                            text.empty() ? "" : "; ", row.name, n, row.lo, row.hi,
                            feather::UnitName(row.unit));
    }
    return text;
}

}  // namespace pbrt
