#include <fmt/format.h>

#include "pbrt/bsdftool/commands.h"
#include "pbrt/feather/pigment.h"

namespace pbrt::bsdftool {
namespace {

TextureEvalContext MiddleOfTexture() {
    TextureEvalContext ctx;
    ctx.uv = {0.5f, 0.5f};
    return ctx;
}

Vector3f ToFloat(const double *v) { return {float(v[0]), float(v[1]), float(v[2])}; }

/// The i-th group of four wavelengths; the last one repeats its last wavelength.
std::array<float, NSpectrumSamples> Group(const std::vector<float> &lambda, size_t i) {
    std::array<float, NSpectrumSamples> group;
    for (size_t k = 0; k < group.size(); ++k)
        group[k] = lambda[std::min(i + k, lambda.size() - 1)];
    return group;
}

template <typename Values>
void Append(std::vector<double> &to, const Values &values, size_t size) {
    for (size_t k = 0; k < NSpectrumSamples && to.size() < size; ++k) to.push_back(values[k]);
}

std::string Join(const std::vector<double> &values) {
    std::string s;
    for (double v : values) s += fmt::format("{}{:.9g}", s.empty() ? "" : ",", v);
    return s;
}

}  // namespace

Evaluation Evaluate(const Material &material, const DirectionPair &pair,
                    const std::vector<float> &lambda) {
    const Vector3f wo = ToFloat(pair.wo), wi = ToFloat(pair.wi);
    const TextureEvalContext ctx = MiddleOfTexture();
    Evaluation e;
    for (size_t i = 0; i < lambda.size(); i += NSpectrumSamples) {
        SampledWavelengths wavelengths = SampledWavelengths::Of(Group(lambda, i));
        std::visit(
            [&](const auto &m) {
                const auto bsdf = m.GetBxDF(ctx, wavelengths);
                if constexpr (requires { bsdf.Parts(wo, wi); }) {
                    const auto parts = bsdf.Parts(wo, wi);
                    e.hasParts = true;
                    e.gap = bsdf.GapFraction(wo);
                    Append(e.R, parts.R, lambda.size());
                    Append(e.TRT, parts.TRT, lambda.size());
                }
                if (i == 0) e.pdf = bsdf.PDF(wo, wi, TransportMode::Radiance);
                Append(e.f, bsdf.f(wo, wi, TransportMode::Radiance), lambda.size());
            },
            material);
    }
    return e;
}

std::optional<Evaluation> EvaluateOracle(const Material &material, const DirectionPair &pair,
                                         const std::vector<float> &lambda) {
    const auto *feather = std::get_if<FeatherBarbuleMaterial>(&material);
    if (!feather) return {};
    using Oracle = feather::Barbule<double, NSpectrumSamples, feather::Converged<16, 8>>;
    const feather::Direction<double> wo{pair.wo[0], pair.wo[1], pair.wo[2]},
        wi{pair.wi[0], pair.wi[1], pair.wi[2]};
    Evaluation e;
    e.hasParts = true;
    for (size_t i = 0; i < lambda.size(); i += NSpectrumSamples) {
        const auto group = Group(lambda, i);
        const Oracle oracle = feather->Oracle<Oracle>(MiddleOfTexture(), group);
        const auto view = oracle.SeenFrom(wo);
        if (i == 0) {
            e.pdf = oracle.Pdf(view, wi);
            e.gap = oracle.GapFraction(wo);
        }
        Append(e.R, oracle.R(view, wi), lambda.size());
        Append(e.TRT, oracle.TRT(view, wi), lambda.size());
        Append(e.f, oracle.f(view, wi), lambda.size());
    }
    return e;
}

std::string JsonLine(const DirectionPair &pair, const std::vector<float> &lambda,
                     const Evaluation &e) {
    const auto triple = [](const double *v) {
        return fmt::format("[{:.9g},{:.9g},{:.9g}]", v[0], v[1], v[2]);
    };
    std::string line =
        fmt::format("{{\"wo\":{},\"wi\":{},\"lambda\":[{}],\"f\":[{}],\"pdf\":{:.9g}",
                    triple(pair.wo), triple(pair.wi),
                    Join(std::vector<double>(lambda.begin(), lambda.end())), Join(e.f), e.pdf);
    if (e.hasParts)
        line += fmt::format(",\"gap\":{:.9g},\"R\":[{}],\"TRT\":[{}]", e.gap, Join(e.R),
                            Join(e.TRT));
    return line + "}";
}

}  // namespace pbrt::bsdftool
