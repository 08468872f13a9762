#include "pbrt/bsdftool/evaluation.h"

#include <fmt/format.h>

#include "pbrt/bsdftool/oracle.h"
#include "pbrt/bsdftool/spectral_bsdf.h"
#include "pbrt/util/check.h"

namespace pbrt::bsdftool {
namespace {

template <typename Values>
void Append(std::vector<double> &to, const Values &values, size_t count) {
    for (size_t k = 0; k < count; ++k)
        to.push_back(values[k]);
}

/// Exactly N wavelengths: the share of the lobes in the pdf is a mean over them.
template <typename T, class Quadrature, int N>
void AppendBarbule(const FeatherBarbuleMaterial &material, const DirectionPair &pair,
                   const float *lambda, Evaluation &e) {
    const auto local = [](const LocalDirection &w) {
        return feather::Direction<T>{T(w.x), T(w.y), T(w.z)};
    };
    std::array<float, N> group;
    std::copy_n(lambda, N, group.begin());
    using Model = feather::Barbule<T, N, Quadrature>;
    const Model model = material.ModelAt<Model>(MiddleOfTexture(), group);
    const auto wi = local(pair.wi);
    const auto view = model.SeenFrom(local(pair.wo));
    if (e.f.empty()) {
        e.pdf = model.PDF(view, wi);
        e.gap = model.GapFraction(local(pair.wo));
    }
    Append(e.f, model.f(view, wi), N);
    Append(e.R, model.R(view, wi), N);
    Append(e.TRT, model.TRT(view, wi), N);
}

template <typename T, class Quadrature>
Evaluation EvaluateBarbule(const FeatherBarbuleMaterial &material, const DirectionPair &pair,
                           const std::vector<float> &lambda) {
    Evaluation e;
    e.hasParts = true;
    for (size_t i = 0; i < lambda.size(); i += 4) {
        const float *group = &lambda[i];
        switch (std::min(lambda.size() - i, size_t(4))) {
            case 1:
                AppendBarbule<T, Quadrature, 1>(material, pair, group, e);
                break;
            case 2:
                AppendBarbule<T, Quadrature, 2>(material, pair, group, e);
                break;
            case 3:
                AppendBarbule<T, Quadrature, 3>(material, pair, group, e);
                break;
            default:
                AppendBarbule<T, Quadrature, 4>(material, pair, group, e);
        }
    }
    return e;
}

std::string Join(const std::vector<double> &values) {
    std::string s;
    for (double v : values)
        s += fmt::format("{}{:.9g}", s.empty() ? "" : ",", v);
    return s;
}

}  // namespace

Evaluation Evaluate(const Material &material, const DirectionPair &pair,
                    const std::vector<float> &lambda) {
    if (const auto *barbule = std::get_if<FeatherBarbuleMaterial>(&material))
        return EvaluateBarbule<float, feather::AdaptiveRule>(*barbule, pair, lambda);
    return WithSpectralBSDF(material, lambda, [&](const auto &spectral) {
        const Vector3f wo = pair.wo.ToFloat(), wi = pair.wi.ToFloat();
        Evaluation e;
        e.pdf = spectral.parts[0].bsdf.PDF(wo, wi, TransportMode::Radiance);
        for (const auto &part : spectral.parts)
            Append(e.f, part.bsdf.f(wo, wi, TransportMode::Radiance), part.count);
        return e;
    });
}

Evaluation EvaluateOracle(const Material &material, const DirectionPair &pair,
                          const std::vector<float> &lambda) {
    DCHECK(HasOracle(material));
    return EvaluateBarbule<double, OracleQuadrature>(std::get<FeatherBarbuleMaterial>(material),
                                                     pair, lambda);
}

std::string JsonLine(const DirectionPair &pair, const std::vector<float> &lambda,
                     const Evaluation &e) {
    const auto triple = [](const LocalDirection &w) {
        return fmt::format("[{:.9g},{:.9g},{:.9g}]", w.x, w.y, w.z);
    };
    std::string line = fmt::format(
        "{{\"wo\":{},\"wi\":{},\"lambda\":[{}],\"f\":[{}],\"pdf\":{:.9g}", triple(pair.wo),
        triple(pair.wi), Join(std::vector<double>(lambda.begin(), lambda.end())), Join(e.f), e.pdf);
    if (e.hasParts)
        line +=
            fmt::format(",\"gap\":{:.9g},\"R\":[{}],\"TRT\":[{}]", e.gap, Join(e.R), Join(e.TRT));
    return line + "}";
}

}  // namespace pbrt::bsdftool
